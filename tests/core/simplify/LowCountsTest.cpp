// SPDX-License-Identifier: Apache-2.0
// What the eye sees of levels with few faces.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <osgPMObjects/core/polish/ImageMeter.h>
#include <osgPMObjects/core/simplify/SimplificationError.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "Foliage.h"
#include "RoundMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::meshOf;

Mesh levelWith(const Mesh& mesh, std::size_t faces, const SimplifySettings& settings)
{
    const CollapseSequence sequence = simplify(mesh, settings);
    return meshAfter(mesh, sequence, stepsToFaces(sequence, faces));
}

/// A tube around the x axis between two ends, closed, with a radius for each end.
Mesh tube(std::uint32_t sides, std::uint32_t rings, double length, double radius)
{
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t side = 0; side < sides; ++side)
        {
            const double turn = 2.0 * std::numbers::pi * side / sides;
            positions.emplace_back(length * ring / (rings - 1), radius * std::cos(turn),
                                   radius * std::sin(turn));
        }
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
        for (std::uint32_t side = 0; side < sides; ++side)
        {
            const std::uint32_t a = ring * sides + side, b = ring * sides + (side + 1) % sides;
            faces.push_back({a, a + sides, b});
            faces.push_back({b, a + sides, b + sides});
        }
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.emplace_back(0.0, 0.0, 0.0);
    positions.emplace_back(length, 0.0, 0.0);
    const std::uint32_t last = (rings - 1) * sides;
    for (std::uint32_t side = 0; side < sides; ++side)
    {
        const std::uint32_t next = (side + 1) % sides;
        faces.push_back({first, side, next});
        faces.push_back({first + 1, last + next, last + side});
    }
    return meshOf(std::move(positions), faces);
}

/// A ball with bumps and a thin tail.
Mesh ballWithTail()
{
    Mesh ball = testsupport::roundMesh(48, 24, testsupport::onBumps);
    Mesh shape = meshOf(ball.positions, {});
    for (const Face& face : ball.faces)
        shape.faces.push_back(
            {{ball.positionOf(face, 0), ball.positionOf(face, 1), ball.positionOf(face, 2)}, 0, 0});
    return testsupport::together(shape, tube(8, 12, 3.0, 0.04), {0.9, 0.0, 0.0});
}

TEST(LowCounts, AThinTailKeepsItsLength)
{
    const Mesh mesh = ballWithTail();
    const Mesh level = levelWith(mesh, 60, {.placement = Placement::optimal});
    EXPECT_GT(extentOfFaces(level).high.x, 3.6);
    EXPECT_NEAR(ImageMeter(mesh).measure(level).areaRatio, 1.0, 0.1);
}

/// 32 stripes of materials on a ball, and a tail of one more: its silhouette is worth more than their last
/// faces.
TEST(LowCounts, LastFacesOfMaterialsDoNotTakeTheTailsPlace)
{
    Mesh mesh = ballWithTail();
    const auto first = static_cast<std::uint32_t>(mesh.materials.size());
    for (std::uint32_t i = 0; i < 32; ++i)
    {
        mesh.materials.push_back({.name = "spot"});
        mesh.faces[40 * i].material = first + i;
    }
    const Mesh level = levelWith(mesh, 40, {.placement = Placement::optimal});
    EXPECT_GT(extentOfFaces(level).high.x, 3.4);
    EXPECT_GT(ImageMeter(mesh).measure(level).areaRatio, 0.8);
}

/// A material of few faces that looks like the largest one is no reason to keep them; one that looks
/// different is.
TEST(LowCounts, LastFacesGoEarlierWhereAnotherMaterialLooksAlike)
{
    Mesh mesh = testsupport::roundMesh(32, 16, testsupport::onBumps);
    const std::size_t first = mesh.materials.size();
    for (std::uint32_t i = 0; i < 16; ++i)
    {
        mesh.materials.push_back({.name = "spot"});
        mesh.faces[40 * i].material = static_cast<std::uint32_t>(first) + i;
    }
    std::vector<glm::vec3> alike(mesh.materials.size(), glm::vec3(0.5f)), different = alike;
    for (std::size_t i = first; i < different.size(); ++i)
        different[i] = glm::vec3(float((i - first) % 4), float((i - first) / 4), 3.0f) / 3.0f;
    const auto missing = [&](std::vector<glm::vec3> colours)
    {
        return countMissingMaterials(
            mesh,
            levelWith(mesh, 200, {.placement = Placement::optimal, .materialColours = std::move(colours)}));
    };
    EXPECT_LE(missing({}), 3u);
    EXPECT_GE(missing(alike), 10u);
    EXPECT_LE(missing(different), 3u);
}

/// Houses far from each other: small against the village, and all that there is to see.
TEST(LowCounts, HousesOfAVillageKeepTheirSilhouettesAtAThird)
{
    Mesh mesh = testsupport::cube();
    for (int i = 1; i < 64; ++i)
        mesh = testsupport::together(mesh, testsupport::cube(), {i % 8 * 16.0, i / 8 * 16.0, 0.1 * (i % 5)});
    const Mesh level = levelWith(mesh, mesh.faces.size() / 3, {.placement = Placement::optimal});
    EXPECT_GT(ImageMeter(mesh).measure(level).areaRatio, 0.9);
}

/// Cubes far from each other, two triangles left for each. A triangle with its corners on a cube has an area
/// of at most the root of 3/4 and half of that as mean silhouette; that of the cube is 6/4 (Cauchy). So
/// levels inside of the houses show at most .58 of them, and only faces that grow when others go can show
/// more.
TEST(LowCounts, HousesOfAVillageKeepTheirSilhouettesAtTwoTrianglesEach)
{
    Mesh mesh = testsupport::cube();
    for (int i = 1; i < 64; ++i)
        mesh = testsupport::together(mesh, testsupport::cube(), {i % 8 * 16.0, i / 8 * 16.0, 0.1 * (i % 5)});
    const ImageMeter meter(mesh);
    const auto areaAt = [&](Placement placement)
    { return meter.measure(levelWith(mesh, 128, {.placement = placement})).areaRatio; };
    const double mostInside = 2.0 * 0.5 * std::sqrt(0.75) / 1.5;
    EXPECT_GT(areaAt(Placement::optimal), 0.9);
    EXPECT_LT(areaAt(Placement::subset), mostInside);
    EXPECT_LT(areaAt(Placement::quality), mostInside); // its faces do not grow
}

TEST(LowCounts, ACrownCoversItsPixelsAtAHundredth)
{
    const Mesh mesh = testsupport::crown(testsupport::LeafKind::quad, 6000, 0.1);
    const ImageMeter meter(mesh, {}, {.views = 6, .sizePx = 128});
    const ImageDifference seen = meter.measure(levelWith(mesh, 120, {.placement = Placement::optimal}));
    EXPECT_GT(seen.covered, 0.8);
    EXPECT_LT(seen.areaRatio, 1.1);
}

/// With subset placement a card can only take corners of others: of all cards merged into it, not of the last
/// one alone.
TEST(LowCounts, ACrownOfTakenCornersCoversItsPixelsAtAHundredth)
{
    const Mesh mesh = testsupport::crown(testsupport::LeafKind::quad, 6000, 0.1);
    const ImageMeter meter(mesh, {}, {.views = 6, .sizePx = 128});
    const ImageDifference seen = meter.measure(levelWith(mesh, 120, {.placement = Placement::subset}));
    EXPECT_GT(seen.covered, 0.72); // .68 with corners of the nearest, or of the last one alone
    EXPECT_LT(seen.areaRatio, 1.1);
}

} // namespace
