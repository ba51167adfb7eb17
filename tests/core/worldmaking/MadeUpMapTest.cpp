// SPDX-License-Identifier: Apache-2.0
// Made-up maps over a made ground: what stands where, and what the measures say of a map in which something
// stands wrong.
#include "worldmaking/madeup/MadeUpMap.h"

#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include <osgRoads/core/network/RoadNetwork.h>

#include "scenery/buildings/Outline.h"
#include "worldmaking/madeup/PlanArea.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/map/ReadLand.h"
#include "worldmaking/plan/PlanGrid.h"

namespace
{

using namespace worldmaking;

constexpr double kLatitudeDeg = 46.0, kLongitudeDeg = 8.0, kPerDegree = 111320.0;

/// A plain in the south that rises to hills in the north, and a hollow in it.
std::optional<double> hillyGround(double latitudeDeg, double longitudeDeg)
{
    const double north = (latitudeDeg - kLatitudeDeg) * kPerDegree,
                 east = (longitudeDeg - kLongitudeDeg) * kPerDegree * std::cos(kLatitudeDeg * 0.0174532925);
    const double rise = std::max(0.0, north);
    return 300.0 + 0.002 * north + 0.06 * rise + 25.0 * std::sin(east / 420.0) * std::min(1.0, rise / 900.0) +
           1.5 * std::sin(east / 900.0);
}

MadeUpSettings settingsOf(std::uint64_t seed)
{
    MadeUpSettings settings;
    settings.seed = seed;
    settings.bounds = {kLongitudeDeg - 0.055, kLatitudeDeg - 0.04, kLongitudeDeg + 0.055,
                       kLatitudeDeg + 0.03};
    return settings;
}

const MadeUpMap& madeMap()
{
    static const MadeUpMap map = []
    {
        auto made = makeUpMap(hillyGround, settingsOf(3));
        EXPECT_TRUE(made) << (made ? "" : made.error().message());
        return made ? std::move(*made) : MadeUpMap();
    }();
    return map;
}

/// A map in a plane.
struct Laid
{
    struct Thing
    {
        const LandShape* shape;
        PlanRings paths;
    };
    std::vector<Thing> things;

    explicit Laid(const MadeUpMap& map)
    {
        osgRoads::core::NetworkHeader header;
        header.geoReference =
            "+proj=tmerc +lat_0=46 +lon_0=8 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
        const auto plane = MapPlane::create(header, "made");
        for (const LandShape& shape : map.land.shapes)
            things.push_back({&shape, *plane->toPlan(shape.paths)});
        for (const Runway& runway : map.runways)
            runways.push_back(*stripOf(runway, *plane));
    }

    std::vector<PlanRings> with(const char* key, const char* value = nullptr) const
    {
        std::vector<PlanRings> found;
        for (const Thing& thing : things)
            if (const auto its = valueOf(thing.shape->tags, key); !its.empty() && (!value || its == value))
                found.push_back(thing.paths);
        return found;
    }

    /// The streets, but no squares.
    std::vector<PlanRings> streets() const
    {
        std::vector<PlanRings> found;
        for (const Thing& thing : things)
            if (thing.shape->form == ShapeForm::line && !valueOf(thing.shape->tags, "highway").empty())
                found.push_back(thing.paths);
        return found;
    }

    std::vector<PlanRings> runways;
};

double distanceM(const glm::dvec2& place, const std::vector<glm::dvec2>& line)
{
    double least = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
        const glm::dvec2 along = line[i + 1] - line[i];
        const double share = std::clamp(glm::dot(place - line[i], along) / glm::dot(along, along), 0.0, 1.0);
        least = std::min(least, glm::distance(place, line[i] + share * along));
    }
    return least;
}

/// The least distance of a corner of a house from the middle of a street.
double leastHouseRoomM(const Laid& laid)
{
    double least = 1e300;
    const auto streets = laid.streets();
    for (const PlanRings& house : laid.with("building"))
        for (const glm::dvec2& corner : house.front())
            for (const PlanRings& street : streets)
                least = std::min(least, distanceM(corner, street.front()));
    return least;
}

/// How many areas of one kind have ground in common with one of another.
std::size_t commonCount(const std::vector<PlanRings>& some, const std::vector<PlanRings>& others)
{
    std::size_t count = 0;
    std::vector<std::pair<MapBox, PlanArea>> areas;
    for (const PlanRings& other : others)
        areas.emplace_back(boxOf(other.front()), PlanArea(other).grown(-0.05));
    for (const PlanRings& one : some)
    {
        const PlanArea area(one);
        const MapBox box = boxOf(one.front());
        for (const auto& [otherBox, other] : areas)
            if (box.meets(otherBox) && area.meets(other)) ++count;
    }
    return count;
}

/// How many parts the streets of a map fall into.
std::size_t partsOf(const StreetMap& streets)
{
    std::vector<std::uint32_t> parent(streets.nodes.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t i)
    {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const MapWay& way : streets.ways)
        for (std::size_t i = 0; i + 1 < way.nodes.size(); ++i)
            parent[root(way.nodes[i])] = root(way.nodes[i + 1]);
    std::set<std::uint32_t> roots;
    for (const MapWay& way : streets.ways)
        roots.insert(root(way.nodes.front()));
    return roots.size();
}

TEST(MadeUpMap, HasAllThatAMapHas)
{
    const MadeUpReport& report = madeMap().report;
    EXPECT_GE(report.settlements, 2u);
    EXPECT_EQ(report.unreached, 0u);
    EXPECT_GT(report.houses, 100u);
    EXPECT_GT(report.fields, 100u);
    EXPECT_GT(report.woods, 5u);
    EXPECT_GT(report.roadsKm, 4.0);
    EXPECT_EQ(report.airfields, 1u);
    ASSERT_EQ(madeMap().runways.size(), 1u);
    const Laid laid(madeMap());
    EXPECT_FALSE(laid.with("building", "church").empty());
    EXPECT_FALSE(laid.with("aeroway", "apron").empty());
    EXPECT_FALSE(laid.with("waterway").empty());
}

TEST(MadeUpMap, TheSameSeedGivesTheSameMapAndAnotherAnother)
{
    const auto again = makeUpMap(hillyGround, settingsOf(3)), other = makeUpMap(hillyGround, settingsOf(4));
    ASSERT_TRUE(again && other);
    const auto isSame = [](const MadeUpMap& a, const MadeUpMap& b)
    {
        if (a.land.shapes.size() != b.land.shapes.size()) return false;
        for (std::size_t i = 0; i < a.land.shapes.size(); ++i)
            if (a.land.shapes[i].paths != b.land.shapes[i].paths ||
                a.land.shapes[i].tags != b.land.shapes[i].tags)
                return false;
        return true;
    };
    EXPECT_TRUE(isSame(madeMap(), *again));
    EXPECT_FALSE(isSame(madeMap(), *other));
}

TEST(MadeUpMap, NoHouseStandsOnAStreet)
{
    Laid laid(madeMap());
    EXPECT_GT(leastHouseRoomM(laid), 4.0);
    for (auto& thing : laid.things) // what the measure says of a house that a street runs through
        if (!valueOf(thing.shape->tags, "building").empty())
        {
            const glm::dvec2 aside =
                laid.with("highway", "residential").front().front().front() - thing.paths.front().front();
            for (glm::dvec2& corner : thing.paths.front())
                corner += aside;
            break;
        }
    EXPECT_LT(leastHouseRoomM(laid), 4.0);
}

TEST(MadeUpMap, NoTwoHousesStandOnTheSameGround)
{
    auto houses = Laid(madeMap()).with("building");
    std::size_t pairs = 0;
    const auto countPairs = [&]
    {
        pairs = commonCount(houses, houses) - houses.size(); // each meets itself
        return pairs;
    };
    EXPECT_EQ(countPairs(), 0u);
    houses.push_back(houses.front());
    EXPECT_GT(countPairs(), 0u);
}

TEST(MadeUpMap, NoWoodGrowsOnAFieldOrARunway)
{
    const Laid laid(madeMap());
    auto woods = laid.with("natural", "wood");
    auto fields = laid.with("landuse", "farmland");
    for (const char* use : {"meadow", "orchard"})
        for (auto& field : laid.with("landuse", use))
            fields.push_back(std::move(field));
    EXPECT_EQ(commonCount(woods, fields), 0u);
    EXPECT_EQ(commonCount(woods, laid.runways), 0u);
    EXPECT_EQ(commonCount(fields, laid.runways), 0u);
    woods.push_back(fields.front());
    woods.push_back(laid.runways.front());
    EXPECT_GT(commonCount(woods, fields), 0u);
    EXPECT_GT(commonCount(woods, laid.runways), 0u);
}

TEST(MadeUpMap, NoTwoFieldsHaveGroundInCommon)
{
    auto fields = Laid(madeMap()).with("crop");
    EXPECT_EQ(commonCount(fields, fields), fields.size()); // each with itself
    for (glm::dvec2& corner : fields.front().front())
        corner += glm::dvec2(60.0, 40.0);
    EXPECT_GT(commonCount(fields, fields), fields.size());
}

TEST(MadeUpMap, EverySettlementIsReachedByRoad)
{
    StreetMap streets = streetsOf(madeMap().land);
    EXPECT_EQ(partsOf(streets), 1u);
    for (MapWay& way : streets.ways) // a road that ends 10 m before the next
        if (valueOf(way.tags, "highway") != "residential" && way.nodes.size() > 4)
        {
            way.nodes.erase(way.nodes.begin(), way.nodes.begin() + 2);
            way.nodes.pop_back();
            break;
        }
    EXPECT_GT(partsOf(streets), 1u);
}

/// How far the houses of a map stay from its brooks, without half their width.
double leastBrookRoomM(const Laid& laid, const glm::dvec2& moved)
{
    double least = 1e300;
    for (const Laid::Thing& brook : laid.things)
    {
        if (valueOf(brook.shape->tags, "waterway").empty()) continue;
        const double halfM = 0.5 * std::stod(std::string(valueOf(brook.shape->tags, "width")));
        for (const PlanRings& house : laid.with("building"))
        {
            const auto& ring = house.front();
            if (glm::distance(ring.front(), brook.paths.front().front()) > 2e4) continue;
            for (std::size_t i = 0; i < ring.size(); ++i)
                for (const double share : {0.0, 0.25, 0.5, 0.75})
                    least = std::min(least,
                                     distanceM(glm::mix(ring[i], ring[(i + 1) % ring.size()], share) + moved,
                                               brook.paths.front()) -
                                         halfM);
        }
    }
    return least;
}

TEST(MadeUpMap, NoBrookRunsUnderAHouse)
{
    const Laid laid(madeMap());
    EXPECT_GT(leastBrookRoomM(laid, {}), 1.0);
    double nearest = 1e300; // the control: the houses moved to and fro come onto a brook
    for (double east = -200.0; east <= 200.0; east += 20.0)
        nearest = std::min(nearest, leastBrookRoomM(laid, {east, 0.0}));
    EXPECT_LT(nearest, 0.0);
}

TEST(MadeUpMap, SettlementsLieWhereRoadsLead)
{
    // A wall from north to south that no road climbs; the smaller part is the gentler one.
    const auto parted = [](double latitudeDeg, double longitudeDeg) -> std::optional<double>
    {
        const double east =
            (longitudeDeg - kLongitudeDeg) * kPerDegree * std::cos(kLatitudeDeg * 0.0174532925);
        const double north = (latitudeDeg - kLatitudeDeg) * kPerDegree;
        return 300.0 + std::clamp(2.0 * (east - 1500.0), 0.0, 400.0) +
               (east < 1600.0 ? 12.0 * std::sin(east / 300.0) * std::sin(north / 400.0) : 0.0);
    };
    const auto made = makeUpMap(parted, settingsOf(1));
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_GE(made->report.settlements, 2u);
    EXPECT_EQ(made->report.unreached, 0u);
    for (const MadeUpPlace& place : made->places)
    {
        const bool isSettlement = place.kind == "town" || place.kind == "village" || place.kind == "hamlet";
        EXPECT_TRUE(!isSettlement || (place.degrees.x - kLongitudeDeg) * kPerDegree * 0.6947 < 1600.0);
    }
    EXPECT_EQ(partsOf(streetsOf(made->land)), 1u);
}

TEST(MadeUpMap, GroundForOneSettlementHasARoadThroughIt)
{
    MadeUpSettings settings = settingsOf(1);
    settings.bounds = {8.0, 46.0, 8.026, 46.0099}; // 2 by 1.1 km
    const auto made = makeUpMap(hillyGround, settings);
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_EQ(made->report.settlements, 1u);
    EXPECT_EQ(made->report.unreached, 0u);
    EXPECT_GT(made->report.roadsKm, 0.8);
    EXPECT_GT(made->report.houses, 3u);
}

TEST(MadeUpMap, SummitsAreBare)
{
    const auto mountain = [](double latitudeDeg, double longitudeDeg) -> std::optional<double>
    {
        const double away = std::hypot(latitudeDeg - 46.01, 0.7 * (longitudeDeg - 8.0)) * kPerDegree;
        return *hillyGround(45.99, longitudeDeg) + std::max(0.0, 900.0 - 0.45 * away);
    };
    MadeUpSettings settings = settingsOf(1);
    const auto made = makeUpMap(mountain, settings);
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_LT(made->treeLineM, 1000.0);
    EXPECT_GT(made->treeLineM, 800.0);
    const auto highestWoodM = [&](const MadeUpMap& map)
    {
        double highest = 0.0;
        for (const LandShape& shape : map.land.shapes)
            if (valueOf(shape.tags, "natural") == "wood")
                for (const glm::dvec2& at : shape.paths.front())
                    highest = std::max(highest, *mountain(at.y, at.x));
        return highest;
    };
    EXPECT_LT(highestWoodM(*made), made->treeLineM + 60.0);
    // Lower ground has no summit, and is green to the top.
    EXPECT_EQ(madeMap().treeLineM, settings.treeLineM);
}

TEST(MadeUpMap, RoadsKeepTheGradesOfTheirClasses)
{
    const auto built = buildStreets(streetsOf(madeMap().land), hillyGround, "made up");
    ASSERT_TRUE(built) << built.error().message();
    EXPECT_DOUBLE_EQ(built->report.steepKm, 0.0);
    EXPECT_LT(built->report.steepestPercent, 12.0);
    EXPECT_EQ(built->report.sharpBends, 0u);
    const auto steep = [](double, double longitudeDeg) -> std::optional<double>
    { return 0.25 * (longitudeDeg - kLongitudeDeg) * kPerDegree; };
    const auto onSteep = buildStreets(streetsOf(madeMap().land), steep, "the same on steeper ground");
    ASSERT_TRUE(onSteep);
    EXPECT_GT(onSteep->report.steepestPercent, 12.0);
}

TEST(MadeUpMap, GroundThatIsTooSmallIsTold)
{
    MadeUpSettings settings = settingsOf(1);
    settings.bounds = {8.0, 46.0, 8.01, 46.01};
    const auto made = makeUpMap(hillyGround, settings);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message().find("1 km"), std::string::npos);
}

TEST(MadeUpMap, AMountainSideGetsNoTown)
{
    const auto steep = [](double latitudeDeg, double) -> std::optional<double>
    { return 1000.0 + 0.5 * (latitudeDeg - kLatitudeDeg) * kPerDegree; };
    const auto made = makeUpMap(steep, settingsOf(1));
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message().find("nowhere gentle enough"), std::string::npos);
}

TEST(MadeUpMap, OfALargeGroundTheGentlePartIsFilled)
{
    const auto ground = [](double latitudeDeg, double longitudeDeg) -> std::optional<double>
    { return longitudeDeg < kLongitudeDeg + 0.3 ? 0.0 : *hillyGround(latitudeDeg, longitudeDeg); };
    MadeUpSettings settings = settingsOf(1);
    settings.bounds = {kLongitudeDeg - 0.4, kLatitudeDeg - 0.04, kLongitudeDeg + 0.4, kLatitudeDeg + 0.02};
    const auto made = makeUpMap(ground, settings);
    ASSERT_TRUE(made) << made.error().message();
    ASSERT_FALSE(made->places.empty());
    EXPECT_GT(made->places.front().degrees.x, kLongitudeDeg + 0.3); // the rest is sea
}

} // namespace
