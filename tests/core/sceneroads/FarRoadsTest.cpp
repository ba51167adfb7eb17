// SPDX-License-Identifier: Apache-2.0
// Ribbons on the ground for roads that are far away: where they begin and end.
#include <gtest/gtest.h>

#include "RoadTexts.h"
#include "TunnelScene.h"
#include "scenery/roads/LayRoads.h"

namespace
{

using namespace roadtexts;

/// From where to where the ribbons reach along x.
std::vector<glm::dvec2> reachesOf(const osgRoads::core::PlacedNetwork& roads)
{
    std::vector<glm::dvec2> reaches;
    for (const auto& feature : scenery::farRoads(roads))
        reaches.emplace_back(feature.paths.front().front().x, feature.paths.front().back().x);
    return reaches;
}

std::string roadAt(const std::string& id, double x, const std::string& link)
{
    return road(id, 100.0,
                "<link>" + link + "</link>\n" + "<planView>" +
                    geometry("s=\"0\" x=\"" + std::to_string(x) + R"(" y="0" hdg="0")", 100.0, "<line/>") +
                    "</planView>\n" + twoLanes());
}

} // namespace

/// Ribbons have round ends: of lanes 7 m wide they reach 3.5 m beyond their last point.
TEST(FarRoads, EndWithTheRoadInTheOpenAndGoOnIntoTheNext)
{
    const auto roads = placed(
        network(roadAt("1", 0.0, R"(<successor elementType="road" elementId="2" contactPoint="start"/>)") +
                roadAt("2", 100.0, R"(<predecessor elementType="road" elementId="1" contactPoint="end"/>)")));
    const auto reaches = reachesOf(roads);
    ASSERT_EQ(reaches.size(), 2u);
    EXPECT_NEAR(reaches[0].x, 3.5, 1e-9);
    EXPECT_NEAR(reaches[0].y, 100.0, 1e-9);
    EXPECT_NEAR(reaches[1].x, 100.0, 1e-9);
    EXPECT_NEAR(reaches[1].y, 196.5, 1e-9);
}

TEST(FarRoads, LeaveTunnelsOut)
{
    const auto reaches = reachesOf(*tunnelscene::road());
    const double from = tunnelscene::kPortalX, to = from + tunnelscene::kTunnelM;
    ASSERT_EQ(reaches.size(), 2u);
    EXPECT_NEAR(reaches[0].x, tunnelscene::kRoadX + 3.5, 1e-9);
    EXPECT_NEAR(reaches[0].y, from - 3.5, 1e-9);
    EXPECT_NEAR(reaches[1].x, to + 3.5, 1e-9);
    EXPECT_NEAR(reaches[1].y, tunnelscene::kRoadX + tunnelscene::kLengthM - 3.5, 1e-9);
}

/// A road that is wider than long has none.
TEST(FarRoads, AShortRoadHasNone)
{
    EXPECT_TRUE(reachesOf(placed(network(road("1", 6.0, straightPlan(6.0) + twoLanes())))).empty());
}
