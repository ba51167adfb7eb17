// SPDX-License-Identifier: Apache-2.0
// What is placed on the true ground stands on the drawn one as well, within the pixels that the terrain may
// be off.
#include <algorithm>

#include <gtest/gtest.h>

#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include <osgTerrainROAM/RoamTerrain>

#include "HandCull.h"
#include "SyntheticField.h"
#include "scenery/placement/PlaceScenery.h"
#include "scenery/placement/ReadScenery.h"

namespace
{

using namespace scenery;

constexpr double kTolerancePx = 2.0;
const osg::Vec3d kEye(3000.0, 300.0, 900.0);

/// Of handcull's camera: 60° wide, 800 pixels.
constexpr double kPixelsPerTangent = 400.0 / 0.577350269;

PlacedScenery placedOn(const osgTerrainROAM::RoamTerrain& terrain)
{
    const auto description =
        parseScenery(R"({"fields": [{"name": "wood", "objects": [{"kind": "oak"}], "count": 400,
        "where": {"circle": {"eastM": 3000, "northM": 2000, "radiusM": 1800}, "slopeDeg": [0, 60], "inWater": true}}]})",
                     "wood.json");
    Ground ground;
    ground.heightM = [&](const glm::dvec2& plan) -> std::optional<double>
    {
        const auto point = osgTerrainROAM::core::groundAt(terrain.tile()->tile, plan.x, plan.y);
        return point ? std::optional(point->position.z) : std::nullopt;
    };
    const std::vector<Measures> measures{{5.0, 0.4, {-0.4, -0.4}, {0.4, 0.4}, Stance::upright, true}};
    return placeScenery(*description, measures, ground, {});
}

/// The most that an object's 0 is off the drawn mesh, in pixels of the camera; the mesh is asked as a picker
/// would.
double worstPx(osgTerrainROAM::RoamTerrain& terrain, const PlacedScenery& placed)
{
    double worst = 0.0;
    for (const Placement& p : placed.placements)
    {
        const osg::Vec3d at(p.position.x, p.position.y, p.position.z);
        const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray = new osgUtil::LineSegmentIntersector(
            at + osg::Vec3d(0.0, 0.0, 3000.0), at - osg::Vec3d(0.0, 0.0, 3000.0));
        osgUtil::IntersectionVisitor visitor(ray);
        terrain.accept(visitor);
        EXPECT_TRUE(ray->containsIntersections());
        if (!ray->containsIntersections()) continue;
        // Upright ones stand up to their foundation's margin off the ground at their middle: on slopes of
        // their base.
        const double slack = 0.4;
        const double off = std::max(
            0.0, std::abs(ray->getFirstIntersection().getWorldIntersectPoint().z() - at.z()) - slack);
        worst = std::max(worst, off * kPixelsPerTangent / (at - kEye).length());
    }
    return worst;
}

TEST(SceneryGround, IsTheDrawnGroundWithinTheTerrainsTolerance)
{
    const osg::ref_ptr<osgTerrainROAM::RoamTerrain> terrain =
        new osgTerrainROAM::RoamTerrain(testsupport::planarTile(testsupport::hills(200, 150, 30.0)), nullptr);
    const PlacedScenery placed = placedOn(*terrain);
    ASSERT_EQ(placed.placements.size(), 400u);
    const auto camera = handcull::cameraAt(kEye, {3000.0, 4000.0, 500.0});
    ASSERT_TRUE(terrain->drawable()->setErrorTolerancePx(kTolerancePx));
    handcull::cull(*terrain, *camera, 1);
    EXPECT_LE(worstPx(*terrain, placed), kTolerancePx);

    // The mutation: a ground that may be drawn worse is farther off.
    ASSERT_TRUE(terrain->drawable()->setErrorTolerancePx(40.0));
    for (unsigned frame = 2; frame < 8; ++frame)
        handcull::cull(*terrain, *camera, frame);
    EXPECT_GT(worstPx(*terrain, placed), kTolerancePx);
}

} // namespace
