// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/RoadsInScene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/query/RoadPosition.h>

#include "SyntheticField.h"
#include "scenery/roads/PlaceRoads.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr double kLengthM = 14000.0;

/// Bends of 100 m to and fro; it climbs, and has a step at 9 km.
std::filesystem::path longFile()
{
    const auto file = std::filesystem::path(testing::TempDir()) / "long.xodr";
    std::ofstream stream(file);
    stream.precision(17);
    stream
        << R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="14000" junction="-1"><planView>)";
    constexpr double kCurvature = 0.002, kPieceM = 100.0;
    glm::dvec2 at(-7000.0, 100.0);
    double heading = 0.2;
    for (int i = 0; i < 140; ++i)
    {
        const double curvature = i % 2 == 0 ? kCurvature : -kCurvature;
        stream << "<geometry s=\"" << i * kPieceM << "\" x=\"" << at.x << "\" y=\"" << at.y << "\" hdg=\""
               << heading << "\" length=\"" << kPieceM << "\"><arc curvature=\"" << curvature
               << "\"/></geometry>";
        const double end = heading + curvature * kPieceM;
        at += glm::dvec2(std::sin(end) - std::sin(heading), std::cos(heading) - std::cos(end)) / curvature;
        heading = end;
    }
    stream << R"(</planView><elevationProfile><elevation s="0" a="2" b="0.01" c="0.000002" d="0"/>
<elevation s="9000" a="257" b="0" c="0" d="0.00000000001"/></elevationProfile>
<lanes><laneSection s="0"><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>
</laneSection></lanes></road></OpenDRIVE>)";
    return file;
}

} // namespace

TEST(RoadsInScene, ALongRoadIsWhereItIsPlaced)
{
    const PlacedTile tile(testsupport::onTheEarth(testsupport::hills(65, 65)), Placement::curved);
    const auto middle = tile.frame().geodeticFromLocal(tile.position(32, 32));
    const auto roads =
        scenery::placeRoads({longFile(), scenery::RoadOrigin{middle.latitudeDeg, middle.longitudeDeg, 90.0},
                             scenery::RoadHeights::file},
                            tile);
    ASSERT_TRUE(roads) << roads.error().message();
    const auto network = scenery::roadsInScene(*roads->placed);
    const auto& elevation = roads->placed->network().roads[0].elevation;
    double worstM = 0.0, mostLiftM = -1e9, leastLiftM = 1e9;
    for (double s = 0.5; s < kLengthM; s += 37.3)
    {
        const glm::dvec3 placed = roads->placed->point({0, s, 0.0, 0.0});
        worstM =
            std::max(worstM, glm::distance(placed, osgRoads::core::worldPosition(network, {0, s, 0.0, 0.0})));
        const double lift = placed.z - elevation.value(s);
        mostLiftM = std::max(mostLiftM, lift);
        leastLiftM = std::min(leastLiftM, lift);
    }
    EXPECT_LT(worstM, 0.02);
    // The control: no one lift, and no straight line of it, would do.
    EXPECT_GT(mostLiftM - leastLiftM, 3.0);
}
