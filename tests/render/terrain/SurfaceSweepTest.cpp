// SPDX-License-Identifier: Apache-2.0
// Water and snow on a road, a painted runway, fields, a roof and a crown, in 200 steps each: the picture gets
// darker or brighter steadily, no step changes its mean by more than 2 %, nothing is black.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <osg/Geode>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "FeatureScene.h"
#include "RenderedPicture.h"
#include "RoadTexts.h"
#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/RoadShading.h"
#include "scenery/nodes/SurfaceLook.h"

namespace
{

using namespace osgTerrainROAM;
using simulation::SurfaceWeather;

constexpr int kSweepWidthPx = 96, kSweepHeightPx = 54, kSweepSteps = 200;

osg::ref_ptr<osg::Node> block(const osg::Vec3f& from, const osg::Vec3f& to, scenery::Finish finish)
{
    scenery::ModelMesh mesh;
    mesh.addBox(from, to, {0.45F, 0.35F, 0.3F, 1.0F});
    const osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(mesh.geometry());
    scenery::setObjectShading(*node, finish);
    return node;
}

/// A road on the ground with what stands beside it, seen from a window in the first floor.
class Street
{
public:
    Street()
        : _root(new osg::Group),
          _air(new osgSky::Atmosphere),
          _ground(featurescene::plain(
              {featurescene::line(core::FeatureKind::road, 8.0, {-40.0, 30.0}, {140.0, 30.0})})),
          _look(*_root->getOrCreateStateSet())
    {
        _air->addUniformsTo(*_root->getOrCreateStateSet());
        _ground->setAtmosphere(_air);
        _root->addChild(_ground);
        using namespace roadtexts;
        const auto network = std::make_shared<const osgRoads::core::RoadNetwork>(
            sound(roadtexts::network(road("1", 100.0, straightPlan(100.0) + twoLanes()))));
        const osg::ref_ptr<osg::Node> road =
            scenery::makeRoadNode(std::make_shared<const osgRoads::core::RoadMesh>(
                osgRoads::core::buildRoadMesh(osgRoads::core::PlacedNetwork(network))));
        _root->addChild(road);
        _root->addChild(block({30.0F, 6.0F, 0.0F}, {40.0F, 14.0F, 3.0F}, scenery::Finish::matt));
        _root->addChild(block({30.0F, -14.0F, 0.0F}, {36.0F, -8.0F, 4.0F}, scenery::Finish::foliage));
        osgOffscreen::OffscreenSettings settings;
        settings.widthPx = kSweepWidthPx;
        settings.heightPx = kSweepHeightPx;
        _viewer = rendered::viewerOf(_root, settings);
        if (!_viewer) return;
        _viewer->camera().setProjectionMatrixAsPerspective(50.0, 16.0 / 9.0, 0.5, 1e4);
        _viewer->camera().setViewMatrixAsLookAt({5.0, -4.0, 6.0}, {40.0, 3.0, -2.0}, {0.0, 0.0, 1.0});
    }

    RoamTerrain& ground() { return *_ground; }

    osg::ref_ptr<osg::Image> picture(const SurfaceWeather& surface)
    {
        _look.show(surface, 0.0, std::nullopt);
        return _viewer ? _viewer->picture() : nullptr;
    }

private:
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osgSky::Atmosphere> _air;
    osg::ref_ptr<RoamTerrain> _ground;
    scenery::SurfaceLook _look;
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

/// The mean level of a picture, 0 … 255; below 0: some pixel is black.
double meanOf(const osg::Image& picture)
{
    double sum = 0.0, darkest = 255.0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
        {
            const double level = featurescene::level(picture, x, y);
            sum += level;
            darkest = std::min(darkest, level);
        }
    return darkest < 4.0 ? -1.0 : sum / (picture.s() * picture.t());
}

std::vector<double> sweep(Street& street, const std::function<SurfaceWeather(double)>& at,
                          int steps = kSweepSteps)
{
    std::vector<double> levels;
    for (int i = 0; i <= steps; ++i)
    {
        const osg::ref_ptr<osg::Image> picture = street.picture(at(static_cast<double>(i) / steps));
        if (!picture) return {};
        levels.push_back(meanOf(*picture));
    }
    return levels;
}

/// Returns what is wrong with a sweep: "black", "step" or "back"; empty: nothing. `sense`: 1 brighter, -1
/// darker, 0 either.
std::string flawOf(const std::vector<double>& levels, int sense)
{
    constexpr double kNoise = 0.02; // of a level: the rounding of some hundred pixels
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
        if (!(levels[i] > 0.0)) return "black at step " + std::to_string(i);
        if (i == 0) continue;
        const double change = levels[i] - levels[i - 1];
        if (std::abs(change) > 0.02 * levels[i - 1])
            return "step " + std::to_string(i) + ": " + std::to_string(levels[i - 1]) + " to " +
                   std::to_string(levels[i]);
        if (sense * change < -kNoise) return "back at step " + std::to_string(i);
    }
    return levels.empty() ? "nothing" : "";
}

/// The first snow and the first water are seen most: steps grow with what is there.
SurfaceWeather snow(double share)
{
    return {0.0, 15.0 * share * share};
}
SurfaceWeather moisture(double share)
{
    return {0.5 * share * share};
}

TEST(SurfaceSweep, SnowWhitensSteadily)
{
    Street street;
    const auto levels = sweep(street, snow);
    ASSERT_FALSE(levels.empty());
    EXPECT_EQ(flawOf(levels, 1), "");
    EXPECT_GT(levels.back(), 1.25 * levels.front());
}

TEST(SurfaceSweep, WaterDarkensSteadilyUntilPuddlesMirrorTheSky)
{
    Street street;
    const auto moist = sweep(street, moisture);
    EXPECT_EQ(flawOf(moist, -1), "");
    EXPECT_LT(moist.back(), 0.97 * moist.front());
    EXPECT_EQ(flawOf(sweep(street, [](double share) { return SurfaceWeather{0.5 + 2.0 * share}; }), 0), "");
}

TEST(SurfaceSweep, ClearedRoadsStayDarkWhenTheLandIsWhite)
{
    Street street;
    const auto levelOfRoad = [&](bool isCleared)
    {
        const auto picture = street.picture({0.0, 10.0, false, isCleared});
        return picture ? featurescene::level(*picture, kSweepWidthPx / 2, kSweepHeightPx / 3) : 0.0;
    };
    EXPECT_LT(levelOfRoad(true), 0.8 * levelOfRoad(false));
}

/// Snow that covers all at once, water that is black: each would be seen.
TEST(SurfaceSweep, MutationsWouldBeSeen)
{
    Street street;
    const auto jump = [](double share) { return share < 0.5 ? SurfaceWeather{} : SurfaceWeather{0.0, 15.0}; };
    EXPECT_TRUE(flawOf(sweep(street, jump, 10), 1).starts_with("step 5:"));
    featurescene::mutate(street.ground(), "float fallen = snowShare(depthCm, 2.0",
                         "float fallen = 1.0 - snowShare(depthCm, 2.0");
    EXPECT_NE(flawOf(sweep(street, snow, 20), 1), "");
    Street black;
    featurescene::mutate(black.ground(), "return albedo * (1.0 - lost * surfaceWeather.x)",
                         "return albedo * (1.0 - 4.0 * surfaceWeather.x)");
    EXPECT_EQ(flawOf({meanOf(*black.picture({0.5}))}, -1), "black at step 0");
}

} // namespace
