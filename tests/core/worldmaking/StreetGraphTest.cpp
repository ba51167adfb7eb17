// SPDX-License-Identifier: Apache-2.0
// A map's ways as chains between crossings.
#include "worldmaking/streets/StreetGraph.h"

#include <gtest/gtest.h>

#include "MadeMap.h"
#include "worldmaking/map/ReadOsm.h"

namespace
{

using worldmaking::graphOf;
using worldmaking::StreetGraph;

StreetGraph graphOfMap(const MadeMap& made, double shortestM = 4.0)
{
    const auto map = worldmaking::parseOsm(made.text(), "osm", "made.osm");
    EXPECT_TRUE(map) << (map ? "" : map.error().message());
    std::vector<glm::dvec2> places;
    for (const auto& node : map->nodes)
        places.emplace_back((node.longitudeDeg - MadeMap::kLongitudeDeg) * 81800.0,
                            (node.latitudeDeg - MadeMap::kLatitudeDeg) * MadeMap::kMetresPerDegree);
    return graphOf(*map, places, shortestM);
}

TEST(StreetGraph, WaysThatFollowEachOtherAreOneChain)
{
    MadeMap made;
    const int a = made.node(0, 0), b = made.node(100, 0), c = made.node(200, 0), d = made.node(300, 0);
    made.way({a, b});
    made.way({d, c, b}, {{"highway", "residential"}, {"oneway", "yes"}}); // against the chain
    const StreetGraph graph = graphOfMap(made);
    ASSERT_EQ(graph.chains.size(), 1u);
    EXPECT_TRUE(graph.crossings.empty());
    const auto& chain = graph.chains[0];
    EXPECT_EQ(chain.points.size(), 4u);
    ASSERT_EQ(chain.pieces.size(), 3u);
    EXPECT_EQ(chain.startCrossing, -1);
    EXPECT_EQ(graph.traitsAt(chain, 0).forwardLanes, 1);
    EXPECT_EQ(graph.traitsAt(chain, 1).forwardLanes, 0);
    EXPECT_EQ(graph.traitsAt(chain, 1).backwardLanes, 1);
}

TEST(StreetGraph, ThreeArmsMakeACrossingAndARingHasOne)
{
    MadeMap made;
    const int a = made.node(0, 0), b = made.node(100, 0), c = made.node(200, 0), d = made.node(100, 80);
    made.way({a, b, c});
    made.way({b, d});
    const int e = made.node(500, 0), f = made.node(560, 0), g = made.node(530, 50);
    made.way({e, f, g, e});
    const StreetGraph graph = graphOfMap(made);
    ASSERT_EQ(graph.chains.size(), 4u);
    ASSERT_EQ(graph.crossings.size(), 2u);
    EXPECT_EQ(graph.crossings[0].arms.size(), 3u);
    EXPECT_EQ(graph.crossings[1].arms.size(), 2u);
    EXPECT_EQ(graph.chains[3].startCrossing, graph.chains[3].endCrossing);
}

TEST(StreetGraph, CrossingsCloseTogetherAreOne)
{
    MadeMap made;
    const int a = made.node(0, 0), b = made.node(100, 0), c = made.node(103, 0), d = made.node(200, 0);
    const int e = made.node(100, 80), f = made.node(103, -80);
    made.way({a, b, c, d});
    made.way({b, e});
    made.way({c, f});
    const StreetGraph joined = graphOfMap(made);
    ASSERT_EQ(joined.crossings.size(), 1u);
    EXPECT_EQ(joined.crossings[0].arms.size(), 4u);
    EXPECT_EQ(joined.crossings[0].points.size(), 2u);
    EXPECT_EQ(joined.chains.size(), 4u);
    EXPECT_EQ(graphOfMap(made, 2.0).crossings.size(), 2u);
}

TEST(StreetGraph, ASharedPieceCountsOnce)
{
    MadeMap made;
    const int a = made.node(0, 0), b = made.node(100, 0), c = made.node(200, 0);
    made.way({a, b});
    made.way({b, a});
    made.way({b, c}, {{"highway", "footway"}});
    const StreetGraph graph = graphOfMap(made);
    EXPECT_EQ(graph.chains.size(), 1u);
    EXPECT_EQ(graph.chains[0].pieces.size(), 1u);
    EXPECT_EQ(graph.closedWays, 1u);
}

} // namespace
