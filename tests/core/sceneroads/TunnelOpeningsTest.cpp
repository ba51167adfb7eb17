// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/TunnelOpenings.h"

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/features/OpeningCells.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "ContactDrive.h"
#include "TunnelScene.h"

using namespace osgTerrainROAM::core;
using namespace tunnelscene;

namespace
{

OpeningCells cellsOf(const osgRoads::core::PlacedNetwork& roads)
{
    const auto cells = OpeningCells::build(scenery::tunnelOpenings(roads));
    EXPECT_TRUE(cells);
    return cells ? *cells : OpeningCells{};
}

double groundM(const RoamTile& tile, double x, double y)
{
    return groundAt(tile.tile, x, y)->position.z;
}

} // namespace

TEST(TunnelOpenings, AreTheTubeUpToTheMiddleOfItsLining)
{
    const OpeningCells cells = cellsOf(*road());
    const double x = kPortalX + 100.0, half = 3.5 + 1.0 + 0.3;
    EXPECT_TRUE(cells.isOpen({x, kRoadY + half - 0.05, kRoadM + 1.0}));
    EXPECT_FALSE(cells.isOpen({x, kRoadY + half + 0.05, kRoadM + 1.0}));
    EXPECT_TRUE(cells.isOpen({x, kRoadY, kRoadM + 6.45}));
    EXPECT_FALSE(cells.isOpen({x, kRoadY, kRoadM + 6.55}));
    EXPECT_FALSE(cells.isOpen({kPortalX - 1.0, kRoadY, kRoadM + 1.0})) << "in the open";
}

TEST(TunnelOpenings, ARoadWithoutATunnelHasNone)
{
    EXPECT_TRUE(scenery::tunnelOpenings(*road(false)).empty());
}

TEST(TunnelOpenings, InTheTubeNoGroundIsLeftAboveTheRoad)
{
    const RoadScene scene = sceneOf(ridge(), road());
    const OpeningCells cells = cellsOf(*scene.roads);
    int left = 0, hidden = 0;
    for (double x = kPortalX - 20.0; x < kPortalX + kTunnelM + 20.0; x += 0.7)
        for (double y = -4.4; y <= 4.4; y += 0.4)
        {
            const glm::dvec3 ground(x, kRoadY + y, groundM(*scene.tile, x, kRoadY + y));
            const bool isInTheWay = ground.z > kRoadM && ground.z < kRoadM + 6.0 - 0.3 * std::fabs(y);
            left += isInTheWay && !cells.isOpen(ground) ? 1 : 0;
            hidden += isInTheWay ? 1 : 0;
        }
    EXPECT_EQ(left, 0);
    EXPECT_GT(hidden, 50) << "the slope behind the portals passes through the tube, so the test can fail";
}

TEST(TunnelOpenings, TheHillStaysAsItWas)
{
    const auto before = ridge();
    const RoadScene scene = sceneOf(ridge(), road());
    for (double x = kPortalX + 30.0; x < kPortalX + kTunnelM - 30.0; x += 5.0)
        for (double y = 440.0; y < 520.0; y += 5.0)
            EXPECT_NEAR(groundM(*scene.tile, x, y), groundM(*before, x, y), 1e-3) << x << ' ' << y;
}

TEST(TunnelOpenings, GroundRisesBehindAPortalWithoutAStep)
{
    const RoadScene scene = sceneOf(ridge(), road());
    for (const double y : {-12.0, -7.0, 0.0, 7.0, 12.0})
        for (double x = kPortalX - 6.0; x < kPortalX + 30.0; x += 1.0)
        {
            const double rise =
                groundM(*scene.tile, x + 1.0, kRoadY + y) - groundM(*scene.tile, x, kRoadY + y);
            EXPECT_LT(rise, 2.5) << x << ' ' << y;
        }
    EXPECT_LT(groundM(*scene.tile, kPortalX, kRoadY), kRoadM) << "no ground in front of the mouth";
}

TEST(TunnelOpenings, WheelsInTheTunnelTouchTheRoadThatIsDrawn)
{
    const RoadScene scene = sceneOf(ridge(), road());
    const ContactReport report = contactsOf(scene, driveOver(scene, 30.0), {.everyFrames = 4});
    EXPECT_GT(report.points, 3000U);
    EXPECT_EQ(report.undrawn, 0U);
    EXPECT_EQ(report.broken, 0U) << report.text();
}

TEST(TunnelOpenings, WithoutOpeningsWheelsMeetTheHill) // the test above can fail
{
    RoadScene scene = sceneOf(ridge(), road());
    scene.openings = {};
    const ContactReport report = contactsOf(scene, driveOver(scene, 30.0), {.everyFrames = 4});
    EXPECT_GT(report.broken, 0U);
}
