// SPDX-License-Identifier: Apache-2.0
// Decals in pictures: as large as told near by, as bright as their share from afar.
#include <gtest/gtest.h>

#include <osg/Geode>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include <osgRoads/RoadDrawable>
#include <osgRoads/RoadShader>

#include "RenderedPicture.h"
#include "RoadTexts.h"

namespace
{

using namespace osgRoads;
using namespace roadtexts;

/// A straight road of 100 m with a crosswalk of 4 m over its 7 m at s = 50.
core::RoadMesh crosswalkRoad()
{
    const auto read = std::make_shared<const core::RoadNetwork>(sound(network(road(
        "1", 100.0,
        straightPlan(100.0) + twoLanes() +
            R"(<objects><object id="1" type="crosswalk" s="50" t="0" zOffset="0" hdg="0" length="4" width="7"/></objects>)"))));
    return core::buildRoadMesh(core::PlacedNetwork(read));
}

struct Brightness
{
    double bright = 0.0; ///< share of pixels that are paint
    double mean = 0.0;   ///< of red, green and blue, 0 to 1
};

/// Looks down at s = 50 from a height, through a lens that sees `widthM` of the road.
Brightness seenFrom(core::RoadMesh mesh, double heightM, double widthM)
{
    const osg::ref_ptr<osg::Geode> scene = new osg::Geode;
    scene->addDrawable(new RoadDrawable(std::make_shared<const core::RoadMesh>(std::move(mesh))));
    scene->getOrCreateStateSet()->setAttributeAndModes(makeRoadProgram());
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = settings.heightPx = 64;
    const auto viewer = rendered::viewerOf(scene, settings);
    if (!viewer) return {};
    viewer->camera().setProjectionMatrixAsPerspective(
        2.0 * osg::RadiansToDegrees(std::atan(0.5 * widthM / heightM)), 1.0, 0.5, 1e4);
    viewer->camera().setViewMatrixAsLookAt({50.0, 0.0, heightM}, {50.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    const osg::ref_ptr<osg::Image> picture = viewer->picture();
    Brightness seen;
    const double one = 1.0 / (picture->s() * picture->t());
    for (int row = 0; row < picture->t(); ++row)
        for (int column = 0; column < picture->s(); ++column)
        {
            const osg::Vec4 colour = picture->getColor(column, row);
            if (colour.g() > 0.64F) seen.bright += one;
            seen.mean += one * static_cast<double>(colour.r() + colour.g() + colour.b()) / 3.0;
        }
    return seen;
}

core::RoadMesh withoutPaint(core::RoadMesh mesh)
{
    for (core::MeshVertex& vertex : mesh.vertices)
        vertex.decalRow = 0;
    return mesh;
}

TEST(RoadPaint, ACrosswalkIsAsLargeAsTold)
{
    // 6 m by 6 m: seven stripes of 0.5 m begin at 3.5 m, so 3 m of the 6 m across are paint; 4 m of the 6 m
    // along.
    EXPECT_NEAR(seenFrom(crosswalkRoad(), 8.0, 6.0).bright, 0.5 * 4.0 / 6.0, 0.02);
}

TEST(RoadPaint, ACrosswalkLeftOutIsSeen)
{
    EXPECT_EQ(seenFrom(withoutPaint(crosswalkRoad()), 8.0, 6.0).bright, 0.0);
}

TEST(RoadPaint, StripesThinnerThanAPixelAreTheirShare)
{
    // 128 m on 64 pixels: a stripe is a quarter of a pixel wide. The crosswalk covers 28 of 128 × 7 m of
    // road.
    const double far = seenFrom(crosswalkRoad(), 900.0, 128.0).mean -
                       seenFrom(withoutPaint(crosswalkRoad()), 900.0, 128.0).mean;
    EXPECT_GT(far, 0.0);
    EXPECT_NEAR(far, 0.5 * 28.0 / (128.0 * 128.0) * 0.45, 0.0002);
}

} // namespace
