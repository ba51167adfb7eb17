// SPDX-License-Identifier: Apache-2.0
// Streets of a map that cross, part or meet at small angles.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgRoads/core/network/LaneType.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/write/WriteNetwork.h>

#include "JunctionPaving.h"
#include "MadeStreets.h"
#include "TestFolder.h"

namespace
{

using namespace osgRoads::core;

/// Two streets that cross.
struct Oblique
{
    const char* name;
    MadeMap::MapTags one, other;
};

std::vector<Oblique> obliques()
{
    return {
        {"sidewalks", {{"highway", "tertiary"}}, {{"highway", "residential"}, {"sidewalk", "both"}}},
        {"wide", {{"highway", "primary"}, {"lanes", "4"}}, {{"highway", "secondary"}}},
        {"one way", {{"highway", "residential"}, {"oneway", "yes"}}, {{"highway", "tertiary"}}},
        {"single track", {{"highway", "service"}, {"width", "3"}}, {{"highway", "secondary"}}},
        {"both walked on",
         {{"highway", "residential"}, {"sidewalk", "both"}},
         {{"highway", "residential"}, {"sidewalk", "right"}}},
    };
}

/// Streets of `lengthM` on each side of their crossing.
MadeMap obliqueMap(const Oblique& kinds, double angleDeg, double lengthM)
{
    const double angle = angleDeg * 3.14159265358979 / 180.0;
    const glm::dvec2 way = lengthM * glm::dvec2(std::cos(angle), std::sin(angle));
    MadeMap map;
    const int middle = map.node(0.0, 0.0);
    map.way({map.node(-lengthM, 0.0), middle, map.node(lengthM, 0.0)}, kinds.one);
    map.way({map.node(-way.x, -way.y), middle, map.node(way.x, way.y)}, kinds.other);
    return map;
}

PlacedNetwork obliqueNetwork(const MadeMap& map, const testsupport::TestFolder& folder)
{
    const auto plane = [](double eastM, double northM) { return 1000.0 + 0.03 * eastM - 0.02 * northM; };
    const auto file = folder / "roads.xodr";
    EXPECT_TRUE(writeNetwork(streetsOf(map, plane).network, file));
    auto read = readNetwork(file);
    EXPECT_TRUE(read && read->problems.empty());
    return PlacedNetwork(std::make_shared<const RoadNetwork>(std::move(read->network)));
}

/// What a driver would see wrong on the lanes of a network.
struct LaneFaults
{
    std::size_t places = 0;  ///< that were looked at
    std::size_t covered = 0; ///< of them not paved as drawn
    std::size_t shared = 0;  ///< of roads outside of crossings, that lie on lanes of another such road
    glm::dvec2 place{0.0};   ///< of the last fault
    double foldedM2 = 0.0;
};

/// Calls `use(s, t)` for places of the lanes for cars, half a metre along and a quarter across.
template<class Use>
void forLanePlaces(const Road& road, const Use& use)
{
    for (double s = 0.25; s < road.length; s += 0.5)
        for (const int sign : {-1, 1})
            forLanesOutwards(road, *sectionAt(road, s), sign, s,
                             [&](const LaneSpan& span)
                             {
                                 if (!isForCars(span.lane->type)) return true;
                                 const double low = std::min(span.innerT, span.outerT);
                                 for (double t = low + 0.1; t < low + span.width() - 0.09; t += 0.25)
                                     use(s, t);
                                 return true;
                             });
}

LaneFaults laneFaultsOf(const PlacedNetwork& network)
{
    const DrawnRoads drawn(buildRoadMesh(network));
    LaneFaults faults;
    faults.foldedM2 = drawn.foldedM2();
    const auto isStreetsLane = [&](const RoadMatch& match)
    {
        const Road& other = network.road(match.position.road);
        const auto lane = laneAt(other, match.position.s, match.position.t);
        return other.junctionId.empty() && lane && isForCars(lane->lane->type);
    };
    for (int i = 0; i < static_cast<int>(network.network().roads.size()); ++i)
        forLanePlaces(network.road(i),
                      [&](double s, double t)
                      {
                          const glm::dvec2 place(network.surfacePoint(i, s, t));
                          const auto sample = drawn.at(place);
                          ++faults.places;
                          if (!sample || !sample->isPaved()) ++faults.covered, faults.place = place;
                          if (!network.road(i).junctionId.empty()) return;
                          if (network.locator().holdsOnOther(place, 0.0, i, isStreetsLane))
                              ++faults.shared, faults.place = place;
                      });
    return faults;
}

void expectNone(const LaneFaults& faults, const std::string& what)
{
    EXPECT_GT(faults.places, 10000u) << what;
    EXPECT_EQ(faults.covered, 0u) << what << ": " << faults.place.x << ", " << faults.place.y;
    EXPECT_EQ(faults.shared, 0u) << what << ": " << faults.place.x << ", " << faults.place.y;
    EXPECT_LT(faults.foldedM2, 0.1) << what;
}

} // namespace

TEST(SmallAngles, StreetsThatCrossHaveLanesOfTheirOwnAndNothingLiesOnThem)
{
    const testsupport::TestFolder folder("angles");
    for (const Oblique& kinds : obliques())
        for (const double angleDeg : {6.0, 12.0, 20.0, 33.0, 44.0})
            expectNone(laneFaultsOf(obliqueNetwork(obliqueMap(kinds, angleDeg, 300.0), folder)),
                       kinds.name + (" at " + std::to_string(angleDeg)));
}

TEST(SmallAngles, TheLookSeesSharedLanesFoldsAndWhatLiesOnLanes)
{
    const testsupport::TestFolder folder("angles");
    const PlacedNetwork sound = obliqueNetwork(obliqueMap(obliques()[0], 20.0, 300.0), folder);
    const auto changed = [&](const auto& change)
    {
        auto network = std::make_shared<RoadNetwork>(sound.network());
        change(network->roads);
        network->index();
        return laneFaultsOf(PlacedNetwork(network));
    };
    const auto isWalkedHairpin = [](const Road& road)
    {
        const double turn =
            road.referenceLine.at(road.length).headingRad - road.referenceLine.at(0.0).headingRad;
        return !road.junctionId.empty() && std::cos(turn) < -0.8 &&
               road.sections.front().right.back().type == LaneType::sidewalk;
    };
    const LaneFaults folded = changed(
        [&](std::vector<Road>& roads)
        {
            for (Road& road : roads)
                if (isWalkedHairpin(road))
                    road.sections.front().right.back().width = CubicProfile({Cubic{0.0, 1.5}});
        });
    EXPECT_GT(folded.foldedM2, 0.1);
    // A street that begins within its crossing, as far as others were clear at 30 m.
    const auto isStreet = [](const Road& road) { return road.junctionId.empty(); };
    const auto moved = [&](double aheadM, double upM)
    {
        return [=](std::vector<Road>& roads)
        {
            Road& road = *std::find_if(roads.begin(), roads.end(), isStreet);
            const auto start = road.referenceLine.at(0.0);
            road.referenceLine = ReferenceLine({PlanElement(
                0.0, road.length, start.position + aheadM * start.tangent(), start.headingRad, LineShape{})});
            road.elevation = CubicProfile({Cubic{0.0, road.elevation.value(0.0) + upM, 0.03}});
        };
    };
    EXPECT_GT(changed(moved(-100.0, 0.0)).shared, 0u);
    const LaneFaults over = changed(
        [&](std::vector<Road>& roads)
        {
            moved(-100.0, 2.0)(roads);
            for (Lane& lane : std::find_if(roads.begin(), roads.end(), isStreet)->sections.front().right)
                lane.type = LaneType::sidewalk;
        });
    EXPECT_GT(over.covered, 0u);
}
