// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/RoadModel.h"

#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scenery/models/ModelCheck.h"
#include "scenery/models/Paint.h"
#include "scenery/models/roads/LampArrow.h"
#include "scenery/models/roads/RoadBuilding.h"
#include "scenery/models/roads/Sweep.h"

using namespace scenery::models;

namespace
{

std::vector<RoadModel> allModels()
{
    std::vector<RoadModel> models;
    for (int kind = 0; kind <= static_cast<int>(RoadModel::Kind::box); ++kind)
        for (int shape = 0; shape <= static_cast<int>(RoadModel::Shape::square); ++shape)
        {
            RoadModel model;
            model.kind = static_cast<RoadModel::Kind>(kind);
            model.shape = static_cast<RoadModel::Shape>(shape);
            model.raisedM = 2.0;
            model.postDepthM = kPostDepthM;
            model.text = "A 24";
            models.push_back(model);
        }
    return models;
}

/// Returns how many pixels of two cells differ clearly.
int differing(const Picture& picture, const SignCell& a, const SignCell& b)
{
    const auto pixelOf = [&](const SignCell& cell)
    { return glm::ivec2(cell.low.x * picture.widthPx, cell.low.y * picture.heightPx); };
    const glm::ivec2 from = pixelOf(a), to = pixelOf(b);
    int count = 0;
    for (int y = 0; y < kSignCellPx - 6; ++y)
        for (int x = 0; x < kSignCellPx - 6; ++x)
            for (int c = 0; c < 3; ++c)
            {
                const int step = picture.at(from.x + x, from.y + y)[c] - picture.at(to.x + x, to.y + y)[c];
                count += std::abs(step) > 60 ? 1 : 0;
            }
    return count;
}

} // namespace

TEST(RoadModel, EveryModelIsOneAndStandsInTheGround)
{
    for (const RoadModel& model : allModels())
    {
        const Model made = makeRoadModel(model);
        EXPECT_EQ(defectOf(made), "") << static_cast<int>(model.kind);
        EXPECT_EQ(made.surfaces.size(), model.kind == RoadModel::Kind::runwaySign ? 2U : 1U);
        EXPECT_TRUE(model.kind == RoadModel::Kind::cone || made.foundationM > 0.25)
            << static_cast<int>(model.kind);
    }
}

TEST(RoadModel, BodiesAreClosed)
{
    for (const RoadModel& model : allModels())
    {
        const Model made = makeRoadModel(model);
        for (const auto& part : made.mesh.parts)
            EXPECT_TRUE(isClosed(made.mesh, part.name)) << static_cast<int>(model.kind) << ' ' << part.name;
    }
}

TEST(RoadModel, ThePlateFacesTheDriverThatComes)
{
    RoadModel model;
    model.kind = RoadModel::Kind::sign;
    model.raisedM = 2.0;
    const Model made = makeRoadModel(model);
    // The face looks towards -x; the back, 2 cm behind it, touches the post of 76 mm at x = 0.
    const auto isInFront = [&](const auto& face, int corner)
    { return std::fabs(made.mesh.at(face, corner).x + 0.058) < 1e-3; };
    int faces = 0;
    for (const auto& face : made.mesh.faces)
        if (isInFront(face, 0) && isInFront(face, 1) && isInFront(face, 2))
        {
            ++faces;
            for (const std::uint32_t wedge : face.wedges)
                EXPECT_LT(made.mesh.normals[wedge].x, -0.99F);
        }
    EXPECT_EQ(faces, 22);
}

TEST(SignAtlas, LimitsOfDifferentSpeedsLookDifferent)
{
    const Picture picture = paint(Painting::plain);
    EXPECT_GT(differing(picture, cellOfLimit(50, false), cellOfLimit(80, false)), 150);
    EXPECT_GT(differing(picture, cellOfLimit(50, false), cellOfLimit(0, false)), 400);
    EXPECT_EQ(differing(picture, cellOfLimit(50, false), cellOfLimit(50, false)), 0);
    EXPECT_EQ(differing(picture, cellOfLimit(51, false), cellOfLimit(0, false)),
              0); // no such sign: a ring without a number
}

TEST(SignAtlas, NoTwoFacesAreTheSame)
{
    const Picture picture = paint(Painting::plain);
    const auto isPlainRing = [](SignFace face)
    { return face == SignFace::noVehicles || face == SignFace::limit; };
    for (int a = 0; a < static_cast<int>(SignFace::least); ++a)
        for (int b = 0; b < a; ++b)
        {
            const auto first = static_cast<SignFace>(a), second = static_cast<SignFace>(b);
            if (isPlainRing(first) && isPlainRing(second)) continue;
            EXPECT_GT(differing(picture, cellOf(first), cellOf(second)), 100) << a << ' ' << b;
        }
}

TEST(RoadBuilding, IsAModelWhicheverWayItsOutlineRuns)
{
    const std::vector<glm::dvec3> corners{{0, 0, 0}, {10, 0, 0}, {10, 4, 0}, {4, 4, 0}, {4, 9, 0}, {0, 9, 0}};
    const Model left = makeOutlineBuilding(corners, std::vector<double>(6, 5.0));
    const Model right = makeOutlineBuilding({corners.rbegin(), corners.rend()}, std::vector<double>(6, 5.0));
    for (const Model& model : {left, right})
    {
        EXPECT_EQ(defectOf(model), "");
        EXPECT_EQ(model.heightM, 5.0);
        EXPECT_EQ(model.mesh.faces.size(), 6U * 2U + 4U);
    }
}

TEST(Sweep, IsClosed)
{
    ModelBuilder builder;
    builder.begin("bar", kPlain);
    const std::vector<glm::dvec2> profile{{-0.1, 0.0}, {0.1, 0.0}, {0.1, 1.0}, {-0.1, 1.0}};
    addSweep(builder,
             {{{0, 0, 0}, {0, 1}, profile}, {{4, 0, 0.5}, {0, 1}, profile}, {{8, 1, 0.5}, {0, 1}, profile}});
    const Model model = builder.finish();
    EXPECT_EQ(defectOf(model), "");
    EXPECT_TRUE(isClosed(model.mesh, "bar"));
    double volume = 0.0;
    for (const auto& face : model.mesh.faces)
        volume +=
            glm::dot(model.mesh.at(face, 0), glm::cross(model.mesh.at(face, 1), model.mesh.at(face, 2))) /
            6.0;
    EXPECT_GT(volume, 0.0); // faces look outwards
}

namespace
{

/// The box around a part of a model.
struct Box
{
    glm::dvec3 low{1e9}, high{-1e9};
};

Box boxOf(const Model& model, const std::string& part)
{
    Box box;
    for (const auto& face : model.mesh.faces)
        for (int corner = 0; corner < 3; ++corner)
            if (model.mesh.parts[face.part].name == part)
            {
                const glm::dvec3 at(model.mesh.at(face, corner));
                box = {glm::min(box.low, at), glm::max(box.high, at)};
            }
    return box;
}

RoadModel tiltedSign(double pitchRad, double rollRad)
{
    RoadModel model;
    model.kind = RoadModel::Kind::sign;
    model.shape = RoadModel::Shape::square;
    model.widthM = model.heightM = 1.0;
    model.raisedM = 2.0;
    model.postDepthM = kPostDepthM;
    model.pitchRad = pitchRad;
    model.rollRad = rollRad;
    return model;
}

} // namespace

TEST(RoadModel, APlateIsPitchedAboutItsMiddleAndClearsItsPost)
{
    const Model level = makeRoadModel(tiltedSign(0.0, 0.0)), pitched = makeRoadModel(tiltedSign(0.5, 0.0));
    const Box before = boxOf(level, "plate"), after = boxOf(pitched, "plate");
    EXPECT_NEAR(after.high.z - after.low.z, std::cos(0.5), 0.03);
    EXPECT_NEAR(after.high.x - after.low.x, std::sin(0.5), 0.03);
    EXPECT_NEAR(0.5 * (after.low.z + after.high.z), 2.5, 0.03);
    EXPECT_LE(after.high.x, before.high.x + 0.03);
    const Box post = boxOf(pitched, "post");
    EXPECT_EQ(post.low.x, boxOf(level, "post").low.x);
    // Without the way forward it would reach half of its height times sin 0.5 behind the front of its post.
    EXPECT_GT(before.high.x + 0.5 * std::sin(0.5), post.high.x + 0.1);
}

TEST(RoadModel, ARolledPlateStandsOnItsCorner)
{
    const Box rolled = boxOf(makeRoadModel(tiltedSign(0.0, std::acos(std::sqrt(0.5)))), "plate");
    EXPECT_NEAR(rolled.high.z - rolled.low.z, std::sqrt(2.0), 1e-3);
    // Positive roll raises the left side.
    const Model slightly = makeRoadModel(tiltedSign(0.0, 0.1));
    double highest = -1e9, leftOfIt = 0.0;
    for (const glm::dvec3& at : slightly.mesh.positions)
        if (at.z > highest)
        {
            highest = at.z;
            leftOfIt = at.y;
        }
    EXPECT_GT(leftOfIt, 0.4);
}

TEST(RoadModel, ABoardHasItsLinesBelowEachOther)
{
    RoadModel board;
    board.kind = RoadModel::Kind::board;
    board.heightM = 1.0;
    board.widthM = 2.0;
    board.text = "AB";
    const Box one = boxOf(makeRoadModel(board), "letters");
    board.text = "AB\nAB";
    const Box two = boxOf(makeRoadModel(board), "letters");
    EXPECT_NEAR(one.high.z - one.low.z, 0.6, 0.01);
    EXPECT_NEAR(two.high.z - two.low.z, 0.9, 0.01); // two rows of 0.4 m, 0.5 m apart
}

TEST(RoadModel, LettersOfOtherAlphabetsThanAsciiAreReadable)
{
    const Picture picture = paint(Painting::plain);
    const SignCell blank = cellOfGlyph('\xFE'), a = cellOfGlyph('A');
    for (const char letter : {'\xC4', '\xC5', '\xC9', '\xD6', '\xDC', '/', '('})
    {
        EXPECT_GT(differing(picture, cellOfGlyph(letter), blank), 500) << letter;
        EXPECT_GT(differing(picture, cellOfGlyph(letter), a), 100) << letter;
    }
    EXPECT_GT(differing(picture, cellOfLimit(140, false), cellOf(SignFace::limit)), 500);
}

TEST(RoadModel, ArrowsOfLampsAreMirrorImages)
{
    const auto areaOf = [](RoadModel::Arrow arrow, double side)
    {
        double area = 0.0;
        for (const auto& piece : arrowPieces(arrow))
        {
            double twice = 0.0, middle = 0.0;
            for (std::size_t i = 0; i < piece.size(); ++i)
            {
                const glm::dvec2 a = piece[i], b = piece[(i + 1) % piece.size()];
                twice += a.x * b.y - a.y * b.x;
                middle += a.x / static_cast<double>(piece.size());
                EXPECT_LT(glm::length(a), 1.0);
            }
            EXPECT_GT(twice, 0.0); // counter-clockwise
            if (side * middle > 0.0) area += 0.5 * twice;
        }
        return area;
    };
    using Arrow = RoadModel::Arrow;
    EXPECT_GT(areaOf(Arrow::left, 1.0), areaOf(Arrow::left, -1.0)); // the head is to the left
    EXPECT_NEAR(areaOf(Arrow::left, 1.0), areaOf(Arrow::right, -1.0), 1e-12);
    EXPECT_NEAR(areaOf(Arrow::leftAhead, 1.0), areaOf(Arrow::rightAhead, -1.0), 1e-12);
    EXPECT_GT(areaOf(Arrow::leftAhead, 1.0), 0.2);
    EXPECT_TRUE(arrowPieces(Arrow::none).empty());
}
