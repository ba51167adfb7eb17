// SPDX-License-Identifier: Apache-2.0
// Footbridges, trams and tunnels of railways in small made maps.
#include "worldmaking/streets/Footbridges.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "MadeCrossings.h"
#include "worldmaking/streets/Overpass.h"

namespace
{

using namespace worldmaking;
using namespace madecrossings;

void addMain(MadeMap& map)
{
    map.way({map.node(-300, 0), map.node(300, 0)}, {{"highway", "secondary"}, {"name", "main"}});
}

using TagList = std::initializer_list<std::pair<const char*, const char*>>;

/// A path from south to north with a bridge in its middle.
void addBridged(MadeMap& map, double eastM, double halfM, TagList path, TagList bridge)
{
    const int a = map.node(eastM, -150), b = map.node(eastM, -halfM), c = map.node(eastM, halfM),
              d = map.node(eastM, 150);
    map.way({a, b}, path);
    map.way({b, c}, bridge);
    map.way({c, d}, path);
}

/// An area about the map's zero.
void addPond(MadeMap& map, double halfEastM, double halfNorthM, const TagList& tags)
{
    const int a = map.node(-halfEastM, -halfNorthM), b = map.node(halfEastM, -halfNorthM),
              c = map.node(halfEastM, halfNorthM), d = map.node(-halfEastM, halfNorthM);
    map.way({a, b, c, d, a}, tags);
}

const Footbridge& bridgeOf(const Streets& streets)
{
    const auto found = std::find_if(streets.footbridges.begin(), streets.footbridges.end(),
                                    [](const Footbridge& bridge) { return !bridge.isRamp; });
    EXPECT_NE(found, streets.footbridges.end());
    return *found;
}

std::size_t rampsOf(const Streets& streets)
{
    return static_cast<std::size_t>(std::count_if(streets.footbridges.begin(), streets.footbridges.end(),
                                                  [](const Footbridge& bridge) { return bridge.isRamp; }));
}

double heightNear(const Footbridge& bridge, const glm::dvec2& place)
{
    std::size_t best = 0;
    for (std::size_t i = 0; i < bridge.points.size(); ++i)
        if (glm::distance(bridge.points[i], place) < glm::distance(bridge.points[best], place)) best = i;
    return bridge.heightsM[best];
}

glm::dvec2 middleOf(const Footbridge& bridge)
{
    return 0.5 * (bridge.points.front() + bridge.points.back());
}

TEST(Footbridges, PassOverAStreetWithRampsAlongTheirPath)
{
    const auto expect = [](const TagList& kind)
    {
        MadeMap map;
        addMain(map);
        addBridged(map, 0, 20, {{"highway", "footway"}}, kind);
        const MadeCrossing made = crossingOf(map);
        const Footbridge& bridge = bridgeOf(made.streets);
        EXPECT_NEAR(heightNear(bridge, middleOf(bridge)), 205.1, 0.1)
            << kind.begin()->second; // 4.5 m, a deck
        ASSERT_EQ(rampsOf(made.streets), 2u);
        for (const Footbridge& ramp : made.streets.footbridges)
        {
            if (!ramp.isRamp) continue;
            EXPECT_NEAR(ramp.heightsM.back(), 200.05, 1e-6);
            const double stepM = glm::distance(ramp.points[0], ramp.points[1]);
            EXPECT_LE((ramp.heightsM[0] - ramp.heightsM[1]) / stepM, 0.1 + 1e-6)
                << "there is room for a gentle one";
        }
        EXPECT_TRUE(made.faults().empty());
    };
    expect({{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}});
    expect({{"highway", "cycleway"}, {"bridge", "yes"}, {"width", "3.5 m"}});
    expect({{"highway", "path"}, {"bridge", "viaduct"}, {"layer", "2"}});
    expect({{"highway", "track"}, {"bridge", "boardwalk"}, {"layer", "1"}});
    expect({{"highway", "service"}, {"access", "no"}, {"bridge", "yes"}, {"layer", "1"}});
}

TEST(Footbridges, HaveStairsWhereThereIsLittleRoomAndSayWhereThereIsNone)
{
    MadeMap map;
    addMain(map);
    map.way({map.node(0, -12), map.node(0, 12)},
            {{"highway", "footway"}, {"bridge", "yes"}}); // no path at its ends
    const MadeCrossing made = crossingOf(map);
    EXPECT_EQ(rampsOf(made.streets), 2u);
    EXPECT_TRUE(made.faults().empty());
    EXPECT_TRUE(made.streets.report.notes.empty());
    MadeMap narrow;
    addMain(narrow);
    narrow.way({narrow.node(0, -8), narrow.node(0, 8)}, {{"highway", "footway"}, {"bridge", "yes"}});
    narrow.way({narrow.node(-300, 12), narrow.node(300, 12)}, {{"highway", "secondary"}});
    const MadeCrossing lacking = crossingOf(narrow);
    ASSERT_EQ(lacking.streets.report.notes.size(), 1u);
    EXPECT_NE(lacking.streets.report.notes[0].find("no room for a ramp"), std::string::npos);
    EXPECT_NE(lacking.streets.report.notes[0].find("42.50007, 1.50000"), std::string::npos)
        << lacking.streets.report.notes[0];
}

TEST(Footbridges, HaveAsManyTreadsAsTheMapSaysOfStairs)
{
    const auto treadsOf = [](const TagList& path)
    {
        MadeMap map;
        addMain(map);
        addBridged(map, 0, 20, path, {{"highway", "footway"}, {"bridge", "yes"}});
        const MadeCrossing made = crossingOf(map);
        int treads = -1;
        for (const Footbridge& ramp : made.streets.footbridges)
            if (ramp.isRamp) treads = ramp.treads;
        return treads;
    };
    EXPECT_EQ(treadsOf({{"highway", "steps"}, {"step_count", "32"}}), 32) << "3.4 m down, 11 cm each";
    EXPECT_EQ(treadsOf({{"highway", "steps"}, {"step_count", "24"}}), 24);
    for (const char* other : {"3", "400", "many", "-30"})
        EXPECT_EQ(treadsOf({{"highway", "steps"}, {"step_count", other}}), 20) << other;
    EXPECT_EQ(treadsOf({{"highway", "steps"}}), 20) << "17 cm each";
    EXPECT_EQ(treadsOf({{"highway", "footway"}, {"step_count", "32"}}), 0) << "a gentle ramp";
}

TEST(Footbridges, KeepClearOfRailsWiresWaterAndPathsAndStandOnPiersBesideThem)
{
    MadeMap map;
    map.way({map.node(-300, 250), map.node(300, 250)});
    map.way({map.node(-300, 0), map.node(300, 0)}, {{"railway", "rail"}, {"electrified", "contact_line"}});
    addBridged(map, 0, 40, {{"highway", "path"}}, {{"highway", "path"}, {"bridge", "yes"}});
    const MadeCrossing made = crossingOf(map);
    const Footbridge& bridge = bridgeOf(made.streets);
    EXPECT_GE(heightNear(bridge, middleOf(bridge)), 206.2 + 0.5); // of the wire, a deck
    EXPECT_FALSE(bridge.piersM.empty());
    for (const double pierM : bridge.piersM)
        EXPECT_GT(std::fabs(pierM - 40.0), 2.5 + 1.0);
    MadeMap wet;
    wet.way({wet.node(-300, 250), wet.node(300, 250)});
    addPond(wet, 20, 30, {{"natural", "water"}});
    addBridged(wet, 0, 40, {{"highway", "path"}}, {{"highway", "path"}, {"bridge", "yes"}});
    const Footbridge over = bridgeOf(crossingOf(wet).streets);
    for (std::size_t i = 0; i < over.points.size(); ++i)
        if (std::fabs(over.points[i].y - middleOf(over).y) < 27.0)
        {
            EXPECT_GE(over.heightsM[i], 201.4 - 1e-6) << i;
        }
}

TEST(Footbridges, OfSeveralWaysAreOneAndThoseBelowStreetsStayLow)
{
    MadeMap map;
    addMain(map);
    const int a = map.node(0, -20), b = map.node(0, 0.5), c = map.node(0, 20), d = map.node(60, 20);
    map.way({a, b}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}});
    map.way({c, b}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}}); // drawn the other way
    map.way({c, d}, {{"highway", "steps"}});
    const auto streets = crossingOf(map).streets;
    EXPECT_EQ(streets.footbridges.size() - rampsOf(streets), 1u);
    // A street on a bridge over a footbridge over water.
    MadeMap stacked;
    const int e = stacked.node(-300, 0), f = stacked.node(-40, 0), g = stacked.node(40, 0),
              h = stacked.node(300, 0);
    stacked.way({e, f}, {{"highway", "secondary"}});
    stacked.way({f, g}, {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "2"}, {"name", "high"}});
    stacked.way({g, h}, {{"highway", "secondary"}});
    addBridged(stacked, 0, 15, {{"highway", "path"}},
               {{"highway", "path"}, {"bridge", "yes"}, {"layer", "1"}});
    const MadeCrossing both = crossingOf(stacked);
    EXPECT_LT(heightNear(bridgeOf(both.streets), middleOf(bridgeOf(both.streets))), 201.0);
    EXPECT_TRUE(both.faults().empty());
}

TEST(Footbridges, BetweenTwoStreetsKeepBothFarEnoughApart)
{
    const auto expect = [](const TagList& below, double footAboveM)
    {
        MadeMap map;
        addStreet(map, 0, "high", {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "2"}}, 100.0);
        map.way({map.node(0, -400), map.node(0, 400)}, below);
        const int a = map.node(-120, -90), b = map.node(-25, -20), c = map.node(25, 18),
                  d = map.node(120, 90); // over the one below and under the bridge
        map.way({a, b}, {{"highway", "footway"}});
        map.way({b, c}, {{"highway", "footway"}, {"bridge", "yes"}, {"layer", "1"}});
        map.way({c, d}, {{"highway", "footway"}});
        const MadeCrossing made = crossingOf(map);
        const Footbridge& foot = bridgeOf(made.streets);
        const Road& high = made.road("high");
        const double underM = heightNear(foot, {0.0, 0.0});
        EXPECT_GE(underM, footAboveM) << below.begin()->second;
        EXPECT_GE(high.elevation.value(0.5 * high.length) - underM, 2.5 + kRoadDeckM - 0.4)
            << below.begin()->second;
        EXPECT_TRUE(made.faults().empty()) << below.begin()->second;
        EXPECT_TRUE(made.streets.report.notes.empty()) << below.begin()->second;
    };
    expect({{"highway", "secondary"}}, 205.0);
    expect({{"railway", "rail"}, {"electrified", "contact_line"}}, 206.6);
    expect({{"railway", "rail"}, {"usage", "main"}}, 205.5);
}

TEST(Footbridges, PassOverEachOtherByTheirLayers)
{
    const auto expect = [](const char* firstLayer, const char* secondLayer, double firstHalfM)
    {
        MadeMap map;
        addMain(map);
        addBridged(map, 0, firstHalfM, {{"highway", "path"}},
                   {{"highway", "path"}, {"bridge", "yes"}, {"layer", firstLayer}});
        const int a = map.node(-150, 10), b = map.node(-40, 10), c = map.node(40, 10), d = map.node(150, 10);
        map.way({a, b}, {{"highway", "path"}});
        map.way({b, c}, {{"highway", "path"}, {"bridge", "yes"}, {"layer", secondLayer}});
        map.way({c, d}, {{"highway", "path"}});
        const MadeCrossing made = crossingOf(map);
        std::vector<double> heightsM; // of both where they cross
        for (const Footbridge& bridge : made.streets.footbridges)
            if (!bridge.isRamp)
            {
                const bool isAlong = std::fabs(bridge.points.front().x - bridge.points.back().x) > 30.0;
                heightsM.push_back(heightNear(
                    bridge,
                    {bridge.points.front().x + (isAlong ? 40.0 : 0.0),
                     isAlong ? bridge.points.front().y : bridge.points.front().y + firstHalfM + 10.0}));
            }
        ASSERT_EQ(heightsM.size(), 2u);
        EXPECT_GE(std::fabs(heightsM[0] - heightsM[1]), 2.5) << firstLayer << secondLayer;
        EXPECT_TRUE(made.faults().empty()) << firstLayer << secondLayer;
    };
    expect("1", "2", 20.0);
    expect("1", "2", 60.0); // the longer one, which would be built first, is below
    expect("2", "1", 20.0);
    expect("3", "1", 60.0);
}

TEST(CrossingCheck, SeesFootbridgesAndRailwaysThatAreTooCloseToEachOther)
{
    MadeMap map;
    map.way({map.node(-300, 250), map.node(300, 250)});
    map.way({map.node(-300, 0), map.node(300, 0)}, {{"railway", "rail"}});
    addBridged(map, 0, 40, {{"highway", "path"}}, {{"highway", "path"}, {"bridge", "yes"}});
    const MadeCrossing made = crossingOf(map);
    EXPECT_TRUE(made.faults().empty());
    auto lines = made.rails();
    for (RailLine& line : lines)
        for (glm::dvec3& place : line.points)
            place.z -= line.isFootbridge ? 2.0 : 0.0;
    const auto faults = made.faultsWith(lines);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].flaw, CrossingFlaw::lines);
    EXPECT_TRUE(faults[0].isUpperFootbridge && !faults[0].isLowerFootbridge);
    EXPECT_NEAR(faults[0].foundM, 2.6, 0.1);
    EXPECT_EQ(faults[0].wantedM, 4.5);
}

TEST(CrossingCheck, EachFlawHasAWordOfItsOwn)
{
    std::set<std::string> words;
    for (int flaw = 0; flaw <= static_cast<int>(CrossingFlaw::lines); ++flaw)
        words.insert(wordOf(static_cast<CrossingFlaw>(flaw)));
    EXPECT_EQ(words, (std::set<std::string>{"footbridge", "lines", "railEnd", "rails", "roads", "tunnel"}));
}

TEST(CrossingCheck, SeesAFootbridgeThatIsTooLow)
{
    MadeMap map;
    addMain(map);
    addBridged(map, 0, 20, {{"highway", "footway"}}, {{"highway", "footway"}, {"bridge", "yes"}});
    const MadeCrossing made = crossingOf(map);
    auto lines = made.rails();
    ASSERT_EQ(lines.size(), 1u);
    for (glm::dvec3& place : lines[0].points)
        place.z -= 1.5;
    const auto faults = made.faultsWith(lines);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].flaw, CrossingFlaw::footbridge);
    EXPECT_NEAR(faults[0].foundM, 3.1, 0.1);
}

/// The greatest distance of the rails of tracks from the surface of a street, where they are in it.
double mostOffStreet(const Streets& streets, const std::string& name)
{
    const auto& roads = streets.network.roads;
    const auto road = std::find_if(roads.begin(), roads.end(), [&](const Road& r) { return r.name == name; });
    double mostM = 0.0;
    for (const Track& track : streets.tracks)
        for (std::size_t i = 0; track.isInStreet && i < track.points.size(); ++i)
        {
            const double streetM =
                road->elevation.value(track.points[i].x - road->referenceLine.at(0.0).position.x);
            mostM = std::max(mostM, std::fabs(track.heightsM[i] + kRailTopM - streetM));
        }
    return mostM;
}

TEST(Trams, InAStreetLieLevelWithItAndLeaveItWithoutAStep)
{
    for (const char* kind : {"tram", "light_rail"})
    {
        MadeMap map;
        addMain(map);
        map.way({map.node(-250, 1.5), map.node(60, 1.5), map.node(140, 60), map.node(140, 200)},
                {{"railway", kind}, {"electrified", "contact_line"}});
        const MadeCrossing made =
            crossingOf(map, [](double eastM, double northM)
                       { return 200.0 + 0.03 * eastM + 0.01 * northM + std::sin(0.05 * eastM); });
        EXPECT_LT(mostOffStreet(made.streets, "main"), 0.1);
        double inM = 0.0;
        std::vector<glm::dvec3> ends;
        for (const Track& track : made.streets.tracks)
        {
            for (std::size_t i = 0; i + 1 < track.points.size(); ++i)
            {
                const double lengthM = glm::distance(track.points[i], track.points[i + 1]);
                inM += track.isInStreet ? lengthM : 0.0;
                EXPECT_LT(std::fabs(track.heightsM[i + 1] - track.heightsM[i]) / lengthM, 0.12) << kind;
            }
            if (!ends.empty())
            {
                EXPECT_NEAR(ends.back().z, track.heightsM.front(), 1e-9);
            }
            ends.emplace_back(track.points.back(), track.heightsM.back());
        }
        EXPECT_NEAR(inM, 310.0, 15.0) << kind;
        EXPECT_TRUE(made.streets.report.notes.empty());
    }
}

TEST(Trams, HaveHeightsOfTheirOwnBesideStreetsAndOverThemOnBridges)
{
    MadeMap map;
    addMain(map);
    addAcross(map, 0, {{"railway", "tram"}, {"bridge", "yes"}, {"layer", "1"}});
    const MadeCrossing made = crossingOf(map);
    ASSERT_FALSE(made.streets.tracks.empty());
    EXPECT_TRUE(made.faults().empty());
    for (const Track& track : made.streets.tracks)
        EXPECT_FALSE(track.isInStreet);
    MadeMap subway;
    addMain(subway);
    addAcross(subway, 0, {{"railway", "subway"}, {"layer", "1"}, {"bridge", "yes"}});
    EXPECT_FALSE(crossingOf(subway).streets.tracks.empty());
}

TEST(RailTunnels, OnLevelGroundAreDugInFromPortalToPortalAndShareATube)
{
    MadeMap map;
    map.way({map.node(-300, 290), map.node(300, 290)});
    for (const double northM : {0.0, 4.0})
    {
        const int a = map.node(-1200, northM), b = map.node(-150, northM), c = map.node(150, northM),
                  d = map.node(1200, northM);
        map.way({a, b}, {{"railway", "rail"}});
        map.way({b, c}, {{"railway", "rail"}, {"tunnel", "yes"}, {"layer", "-1"}});
        map.way({c, d}, {{"railway", "rail"}});
    }
    const MadeCrossing made = crossingOf(map);
    std::size_t tubes = 0;
    for (const Track& track : made.streets.tracks)
    {
        if (track.place != StreetPlace::tunnel) continue;
        ++tubes;
        EXPECT_TRUE(track.isPortalAtStart && track.isPortalAtEnd);
        EXPECT_NE(track.isOpenLeft, track.isOpenRight) << "one side is the other track's";
        EXPECT_LE(track.heightsM[track.heightsM.size() / 2], 200.0 - kTunnelRoofM + 0.1);
    }
    EXPECT_EQ(tubes, 2u);
    EXPECT_TRUE(made.faults().empty());
    auto rails = made.rails();
    for (RailLine& line : rails)
        for (glm::dvec3& place : line.points)
            place.z += 4.0;
    const auto faults = made.faultsWith(rails);
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_EQ(faults[0].flaw, CrossingFlaw::tunnel);
    EXPECT_EQ(faults[0].road, -1);
}

TEST(RailTunnels, BeginWithOnePortalAtASwitch)
{
    MadeMap map;
    map.way({map.node(-300, 290), map.node(300, 290)});
    const int a = map.node(-1200, 0), b = map.node(-150, 0), c = map.node(150, 0), d = map.node(150, 40),
              e = map.node(1200, 0);
    map.way({a, b}, {{"railway", "rail"}});
    map.way({b, c}, {{"railway", "rail"}, {"tunnel", "yes"}, {"layer", "-1"}});
    map.way({b, d}, {{"railway", "rail"}, {"tunnel", "yes"}, {"layer", "-1"}}); // parts in the portal
    map.way({c, e}, {{"railway", "rail"}});
    const auto hill = [](double eastM, double) { return 200.0 + 30.0 * std::exp(-eastM * eastM / 1e4); };
    const MadeCrossing made = crossingOf(map, hill);
    std::size_t portals = 0, tubes = 0;
    for (const Track& track : made.streets.tracks)
    {
        if (track.place != StreetPlace::tunnel)
        {
            EXPECT_FALSE(track.isPortalAtStart || track.isPortalAtEnd);
            continue;
        }
        ++tubes;
        portals += (track.isPortalAtStart ? 1u : 0u) + (track.isPortalAtEnd ? 1u : 0u);
    }
    EXPECT_EQ(tubes, 2u);
    EXPECT_EQ(portals, 2u) << "one at the switch, one at the other end, none where the map ends";
}

TEST(Crossings, OverAnAreaOfWaterBridgesOfStreetsAndRailwaysKeepClearOfIt)
{
    const auto expect = [](const TagList& water)
    {
        MadeMap map;
        addPond(map, 30, 60, water);
        addStreet(map, 0, "over", {{"highway", "secondary"}, {"bridge", "yes"}, {"layer", "1"}}, 40.0);
        const int a = map.node(-400, 30), b = map.node(-40, 30), c = map.node(40, 30), d = map.node(400, 30);
        map.way({a, b}, {{"railway", "rail"}});
        map.way({b, c}, {{"railway", "rail"}, {"bridge", "yes"}});
        map.way({c, d}, {{"railway", "rail"}});
        const MadeCrossing made = crossingOf(map);
        const Road& road = made.road("over");
        EXPECT_GE(road.elevation.value(0.5 * road.length), 202.7)
            << water.begin()->second; // 0.9 m, a deck, rounding
        for (const Track& track : made.streets.tracks)
            if (track.place == StreetPlace::bridge)
            {
                EXPECT_GE(track.heightsM[track.heightsM.size() / 2], 202.0) << water.begin()->second;
            }
    };
    expect({{"natural", "water"}, {"water", "lake"}});
    expect({{"landuse", "reservoir"}});
    expect({{"waterway", "riverbank"}});
    expect({{"natural", "water"}, {"water", "river"}});
    expect({{"landuse", "basin"}});
}

} // namespace
