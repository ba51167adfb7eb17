// SPDX-License-Identifier: Apache-2.0
// What a pilot finds the way by: roads far away stand out from meadow, without gaps and as bright as their
// meshes near by; a runway is seen from 8 km and its marks from 3 km. Differences of colour are those of CIE
// 1976 L*a*b*, of which 2.3 is just seen (Mahy, Van Eycken and Oosterlinck, Evaluation of uniform color
// spaces, 1994).
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <osg/Group>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "FeatureScene.h"
#include "RoadTexts.h"
#include "scenery/nodes/RoadShading.h"

namespace seenfromtheair
{

namespace
{

using namespace osgTerrainROAM;
using namespace featurescene;
using core::FeatureKind;

const osg::Vec3d kUpright(0.0, 0.0, 1.0);
const osg::Vec3d kNorth(0.0, 1.0, 0.0);
constexpr double kSeen = 2.3;

/// As wide as a pixel of a picture of 960 by 540 that shows 60 degrees across.
constexpr double kLensDeg = 18.0, kCoarseLensDeg = 36.0; ///< the second: of 480 by 270

const std::string kAsphalt = "vec3(0.145, 0.143, 0.139)", kAsMeadow = "vec3(0.068, 0.105, 0.029)";

/// L*, a*, b* of a pixel, by sRGB's primaries and white.
osg::Vec3d labOf(const osg::Image& picture, int x, int y)
{
    std::array<double, 3> linear{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const double shown = picture.data(x, y)[i] / 255.0;
        linear[i] = shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
    }
    const auto [r, g, b] = linear;
    const auto f = [](double t)
    { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double fx = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
    const double fy = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
    const double fz = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

/// Mean of the pixels of a box, its borders included.
osg::Vec3d meanLab(const osg::Image& picture, const osg::Vec2d& low, const osg::Vec2d& high)
{
    osg::Vec3d sum;
    double count = 0.0;
    for (int y = static_cast<int>(low.y()); y <= static_cast<int>(high.y()); ++y)
        for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x, count += 1.0)
            sum += labOf(picture, x, y);
    return sum / count;
}

/// A plain with what is painted on it from 1 m on.
osg::ref_ptr<RoamTerrain> paintedFar(const std::vector<core::GroundFeature>& features, double nearestM = 1.0)
{
    const auto terrain = plain({});
    terrain->material()->setFarFeatures(*core::FeatureCells::build(features), nearestM);
    return terrain;
}

core::GroundFeature roadOf(const glm::dvec2& a, const glm::dvec2& b)
{
    auto road = line(FeatureKind::road, 7.0, a, b);
    road.style.marked = false;
    return road;
}

/// How a road stands out from the meadow beside it.
struct Line
{
    double contrast = 0.0; ///< in the mean over 61 places
    double weakest = 0.0;  ///< of five places in a row, as a share of the mean
};

/// A road that leads half aside, looked at from a height, at a distance over the ground.
Line roadFrom(double heightM, double distanceM, const std::string& mutated = "", const std::string& as = "")
{
    const glm::dvec2 middle(20000.0, 20000.0 + distanceM), along = glm::normalize(glm::dvec2(1.0, 1.0));
    const auto terrain = paintedFar({roadOf(middle - 3000.0 * along, middle + 3000.0 * along)});
    if (!mutated.empty()) mutate(*terrain, mutated, as);
    Camera camera(terrain, kLensDeg);
    const osg::Vec3d eye(20000.0, 20000.0, heightM), target(middle.x, middle.y, 0.0);
    const auto picture = camera.picture(eye, target - eye, kUpright);
    const double pixelM = (target - eye).length() * osg::DegreesToRadians(kLensDeg) / kHeightPx;
    std::vector<osg::Vec3d> differences;
    osg::Vec3d mean;
    for (int i = -30; i <= 30; ++i)
    {
        const glm::dvec2 place = middle + along * (2.0 * pixelM * i);
        const osg::Vec2d at = camera.pixelOf({place.x, place.y, 0.0});
        osg::Vec3d beside;
        for (const double side : {-1.0, 1.0})
            beside += meanLab(*picture, {at.x() + side * 30.0 - 10.0, at.y()},
                              {at.x() + side * 30.0 + 10.0, at.y()}) *
                      0.5;
        differences.push_back(meanLab(*picture, at, at) - beside);
        mean += differences.back() / 61.0;
    }
    Line line{mean.length(), 1e9};
    for (std::size_t i = 0; i + 5 <= differences.size(); ++i)
    {
        osg::Vec3d five;
        for (std::size_t j = i; j < i + 5; ++j)
            five += differences[j] / 5.0;
        line.weakest = std::min(line.weakest, (five * mean) / mean.length2());
    }
    return line;
}

/// Means over the asphalt and over the road with both verges, from straight above.
struct Means
{
    osg::Vec3d asphalt, all;
};

constexpr double kRoadNorth = 20000.0;

Means meansOf(osg::Node* scene)
{
    Camera camera(scene);
    const auto picture = camera.picture({20050.0, kRoadNorth, 60.0}, -kUpright, kNorth);
    const auto band = [&](double halfM)
    {
        return meanLab(*picture, camera.pixelOf({20030.0, kRoadNorth - halfM, 0.0}),
                       camera.pixelOf({20070.0, kRoadNorth + halfM, 0.0}));
    };
    return {band(2.5), band(12.0)};
}

/// A road of two lanes as its mesh shows it.
Means meshMeans()
{
    using namespace roadtexts;
    const std::string plan =
        "<planView>" + geometry(R"(s="0" x="20000" y="20000" hdg="0")", 100.0, "<line/>") + "</planView>\n";
    const std::string heights =
        R"(<elevationProfile><elevation s="0" a="0.4" b="0" c="0" d="0"/></elevationProfile>)";
    const auto mesh = std::make_shared<const osgRoads::core::RoadMesh>(
        osgRoads::core::buildRoadMesh(placed(network(road("1", 100.0, plan + heights + twoLanes())))));
    const auto terrain = plain({});
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->setStateSet(terrain->atmosphere()->stateSet());
    scene->addChild(terrain);
    scene->addChild(scenery::makeRoadNode(mesh, terrain));
    return meansOf(scene);
}

Means paintMeans(const std::string& asphalt = kAsphalt)
{
    const auto terrain = paintedFar({roadOf({19900.0, kRoadNorth}, {20200.0, kRoadNorth})});
    mutate(*terrain, kAsphalt, asphalt);
    return meansOf(terrain);
}

/// The threshold's bars beside the asphalt behind them, and the runway beside the meadow, on the middle line
/// of a final of 3 degrees.
struct Final
{
    double bars = 0.0, runway = 0.0; ///< differences of colour
};

Final finalFrom(double distanceM, double lensDeg, const std::string& mutated = "", const std::string& as = "")
{
    const auto terrain = plain(
        {line(FeatureKind::runway, 30.0, {20000.0, 20000.0 + distanceM}, {20000.0, 21500.0 + distanceM})});
    if (!mutated.empty()) mutate(*terrain, mutated, as);
    Camera camera(terrain, lensDeg);
    const auto picture =
        camera.picture({20000.0, 20000.0, 0.0524 * distanceM}, {0.0, 1.0, -0.0524}, kUpright);
    const auto across = [&](double aheadM, double eastM, double wideM)
    {
        const osg::Vec2d low =
            camera.pixelOf({20000.0 + eastM - 0.5 * wideM, 20000.0 + distanceM + aheadM, 0.0});
        const osg::Vec2d high =
            camera.pixelOf({20000.0 + eastM + 0.5 * wideM, 20000.0 + distanceM + aheadM, 0.0});
        return meanLab(*picture, low, {high.x(), low.y()});
    };
    const osg::Vec3d middle = across(700.0, 0.0, 10.0);
    return {(across(21.0, 0.0, 10.0) - middle).length(),
            (middle - (across(700.0, -80.0, 40.0) + across(700.0, 80.0, 40.0)) * 0.5).length()};
}

} // namespace

TEST(SeenFromTheAir, ARoadIsALineFromTwoToEightKilometres)
{
    struct View
    {
        double heightM, distanceM, timesSeen;
    };
    for (const View& view : {View{300.0, 2000.0, 5.0},
                             {900.0, 2000.0, 7.0},
                             {900.0, 4000.0, 3.5},
                             {2000.0, 2000.0, 7.0},
                             {2000.0, 4000.0, 5.0},
                             {2000.0, 8000.0, 2.0}})
    {
        const Line line = roadFrom(view.heightM, view.distanceM);
        SCOPED_TRACE(std::to_string(view.heightM) + " m up, " + std::to_string(view.distanceM) + " m away");
        EXPECT_GT(line.contrast, view.timesSeen * kSeen);
        EXPECT_GT(line.weakest, 0.6) << "a gap";
    }
    EXPECT_LT(roadFrom(900.0, 4000.0, kAsphalt, kAsMeadow).contrast, 2.0 * kSeen)
        << "the control: a road as green as the meadow";
    EXPECT_LT(roadFrom(900.0, 4000.0, "paint.beds = max(paint.beds, beds);",
                       "if (fract(place.y / 200.0) > 0.6) paint.beds = max(paint.beds, beds);")
                  .weakest,
              0.5)
        << "the control: gaps of 120 m";
}

TEST(SeenFromTheAir, ARoadGoesOverFromItsMeshToPaintWithoutAStep)
{
    const Means mesh = meshMeans(), paint = paintMeans(), dark = paintMeans("vec3(0.088, 0.087, 0.086)");
    EXPECT_LT((mesh.all - paint.all).length(), kSeen);
    EXPECT_LT((mesh.asphalt - paint.asphalt).length(), 1.5 * kSeen) << "texels of 4 m blur its edges";
    EXPECT_GT((mesh.all - dark.all).length(), 1.5 * kSeen)
        << "the control: asphalt that is two fifths darker";
    EXPECT_GT((mesh.asphalt - dark.asphalt).length(), 4.0 * kSeen);
}

TEST(SeenFromTheAir, ARunwayIsSeenFromEightKilometresAndItsMarksFromThree)
{
    const Final far = finalFrom(8000.0, kLensDeg), near = finalFrom(3000.0, kLensDeg),
                coarse = finalFrom(3000.0, kCoarseLensDeg);
    EXPECT_GT(far.runway, 4.0 * kSeen);
    EXPECT_GT(near.bars, 4.0 * kSeen);
    EXPECT_GT(coarse.bars, 2.0 * kSeen);
    EXPECT_LT(finalFrom(3000.0, kCoarseLensDeg, "white += 0.5 * bars", "white += 0.0 * bars").bars, kSeen)
        << "the control: no bars far away";
    EXPECT_LT(finalFrom(8000.0, kLensDeg, "shares.x = max(shares.x, share)", "shares.x = 0.0").runway, kSeen)
        << "the control: no runway";
}

TEST(SeenFromTheAir, WhereAMeshIsThinnerThanAPixelItIsPaintedBelowIt)
{
    const auto changed = [](const osg::Vec3d& eye, const osg::Vec3d& place)
    {
        const auto levelAt = [&](const osg::ref_ptr<RoamTerrain>& terrain)
        {
            Camera camera(terrain);
            const auto picture = camera.picture(eye, place - eye, kNorth);
            const osg::Vec2d at = camera.pixelOf(place);
            return level(*picture, static_cast<int>(at.x()), static_cast<int>(at.y()));
        };
        return levelAt(paintedFar({roadOf({19000.0, 20000.0}, {21000.0, 20000.0})}, 3000.0)) !=
               levelAt(plain({}));
    };
    const osg::Vec3d place(20000.0, 20000.0, 0.0);
    EXPECT_TRUE(changed({20000.0, 18700.0, 100.0}, place)) << "at a grazing angle";
    EXPECT_FALSE(changed({20000.0, 19999.0, 1300.0}, place)) << "from above";
    EXPECT_FALSE(changed({20000.0, 19300.0, 40.0}, place)) << "near by";
}

} // namespace seenfromtheair
