// SPDX-License-Identifier: Apache-2.0
// Heights of roads that are laid on ground: two networks worked by hand, and real ones on real hills.
#include "scenery/roads/GroundProfiles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "RealData.h"
#include "scenery/roads/PlaceRoads.h"

namespace
{

using osgRoads::core::ContactPoint;
using osgRoads::core::Road;
using osgRoads::core::RoadLink;
using osgRoads::core::RoadNetwork;
using scenery::BaseSurface;
using scenery::GroundProfileLimits;
using scenery::GroundProfiles;

constexpr double kMostGrade = 0.10, kMostJunctionSlope = 0.04, kMostJoinM = 0.01, kLeastRadiusM = 300.0;
constexpr double kMostGapM = 1.0; ///< between roads that are linked
constexpr double kMapM = 1e-4;    ///< by which a metre of the file differs from one of the scene
constexpr double kLeastShortRadiusM =
    100.0; ///< of roads too short for long bends, and with bends of the file's own
constexpr double kRoundings = 1e-6;

/// A straight road with a lane of 4 m on each side.
struct StraightRoad
{
    int id = 1;
    double x = 0.0, y = 0.0, headingRad = 0.0, lengthM = 100.0;
    std::string links = {}; ///< predecessor and successor
    int junction = -1;

    std::string text() const
    {
        const std::string lane = R"(" type="driving"><width sOffset="0" a="4" b="0" c="0" d="0"/></lane>)";
        std::ostringstream out;
        out.precision(17);
        out << "<road id=\"" << id << "\" length=\"" << lengthM << "\" junction=\"" << junction << "\"><link>"
            << links << "</link><planView><geometry s=\"0\" x=\"" << x << "\" y=\"" << y << "\" hdg=\""
            << headingRad << "\" length=\"" << lengthM
            << "\"><line/></geometry></planView><lanes><laneSection s=\"0\"><left><lane id=\"1" << lane
            << "</left><center><lane id=\"0\" type=\"none\"/></center><right><lane id=\"-1" << lane
            << "</right></laneSection></lanes></road>";
        return out.str();
    }
};

std::shared_ptr<const RoadNetwork> networkOf(const std::string& roads)
{
    auto read = osgRoads::core::parseNetwork(
        "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>" + roads + "</OpenDRIVE>", "by-hand.xodr");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return std::make_shared<const RoadNetwork>(std::move(read->network));
}

/// 4 km along x, over a ridge.
std::shared_ptr<const RoadNetwork> overTheRidge()
{
    return networkOf(StraightRoad{.x = -2000.0, .lengthM = 4000.0}.text());
}

/// The ridge: 200 m high, its flanks climb by 20 %, the plain begins 1000 m from its crest.
std::optional<double> ridgeM(const glm::dvec2& plan)
{
    return std::max(0.0, 200.0 - 0.2 * std::abs(plan.x));
}

/// Four roads of 400 m that meet in a square of 20 m, two connecting roads straight across it; the arms are
/// turned by 30°.
std::shared_ptr<const RoadNetwork> crossing()
{
    std::ostringstream roads;
    constexpr double kTurnRad = 0.5235987755982988, kQuarterRad = 1.5707963267948966, kHalfM = 10.0;
    for (int arm = 0; arm < 4; ++arm)
    {
        const double way = kTurnRad + arm * kQuarterRad;
        roads << StraightRoad{.id = arm + 1,
                              .x = kHalfM * std::cos(way),
                              .y = kHalfM * std::sin(way),
                              .headingRad = way,
                              .lengthM = 400.0,
                              .links = R"(<predecessor elementType="junction" elementId="9"/>)"}
                     .text();
    }
    for (int across = 0; across < 2; ++across)
    {
        const double way = kTurnRad + across * kQuarterRad;
        const std::string from = std::to_string(across + 3), to = std::to_string(across + 1);
        roads << StraightRoad{.id = across + 5,
                              .x = -kHalfM * std::cos(way),
                              .y = -kHalfM * std::sin(way),
                              .headingRad = way,
                              .lengthM = 2.0 * kHalfM,
                              .links =
                                  R"(<predecessor elementType="road" contactPoint="start" elementId=")" +
                                  from +
                                  R"("/><successor elementType="road" contactPoint="start" elementId=")" +
                                  to + "\"/>",
                              .junction = 9}
                     .text();
    }
    return networkOf(
        roads.str() +
        R"(<junction id="9" name="crossing">)"
        R"(<connection id="0" incomingRoad="3" connectingRoad="5" contactPoint="start"/>)"
        R"(<connection id="1" incomingRoad="4" connectingRoad="6" contactPoint="start"/></junction>)");
}

/// A slope of 8 % towards east, no height at x = 0.
std::optional<double> slopeM(const glm::dvec2& plan)
{
    return 0.08 * plan.x;
}

GroundProfiles laidOn(const std::shared_ptr<const RoadNetwork>& network,
                      const foundation::HeightInPlan& ground, const GroundProfileLimits& limits = {})
{
    const auto extent = scenery::extentOf(*network);
    return {network, BaseSurface(extent.low - 1000.0, extent.high + 1000.0, ground), limits};
}

glm::dvec2 leftOf(const osgRoads::core::PlanPoint& line)
{
    return {-line.tangent().y, line.tangent().x};
}

/// The height of a place on a road.
using HeightAt = std::function<double(int road, double s, double t)>;

HeightAt heightsOf(const RoadNetwork& network, const GroundProfiles& profiles)
{
    return [&](int road, double s, double t)
    {
        const auto line = network.roads[static_cast<std::size_t>(road)].referenceLine.at(s);
        return profiles.heightM({road, s, t, 0.0}, line.position + t * leftOf(line));
    };
}

double heightM(const RoadNetwork& network, const GroundProfiles& profiles, int road, double s)
{
    return heightsOf(network, profiles)(road, s, 0.0);
}

/// What is demanded of all roads of a network, at its worst.
struct Worst
{
    double grade = 0.0, curvature = 0.0, junctionSlope = 0.0, joinM = 0.0;

    bool keepsGrade() const { return grade <= kMostGrade + kRoundings; }
    bool keepsRadius() const { return curvature <= 1.0 / kLeastRadiusM + kRoundings; }
    bool keepsJunctions() const { return junctionSlope <= kMostJunctionSlope + kRoundings; }
    bool keepsJoins() const { return joinM <= kMostJoinM; }
};

/// Grade and curvature along the reference line of a road.
void takeProfile(double lengthM, const std::function<double(double s)>& heightAt, Worst& worst)
{
    constexpr double kStepM = 1.0;
    for (double s = kStepM; s + kStepM <= lengthM; s += kStepM)
    {
        const double before = heightAt(s - kStepM), here = heightAt(s), after = heightAt(s + kStepM);
        worst.grade = std::max(worst.grade, std::abs(here - before) / kStepM);
        worst.curvature =
            std::max(worst.curvature, std::abs(after - 2.0 * here + before) / (kStepM * kStepM));
    }
}

/// The steepest way in the plane of a connecting road.
double slopeOf(const HeightAt& heightAt, int road)
{
    constexpr double kStepM = 0.01;
    const double here = heightAt(road, 0.0, 0.0);
    return std::hypot(heightAt(road, kStepM, 0.0) - here, heightAt(road, 0.0, kStepM) - here) / kStepM;
}

/// The greatest difference in height, right across an end of a road, from the road to which it is linked
/// there.
double joinErrorM(const RoadNetwork& network, const HeightAt& heightAt, int index, bool isEnd)
{
    const Road& road = network.roads[static_cast<std::size_t>(index)];
    const std::optional<RoadLink>& link = isEnd ? road.successor : road.predecessor;
    if (!link || link->isJunction || link->index < 0) return 0.0;
    const double s = isEnd ? road.length : 0.0;
    const Road& other = network.roads[static_cast<std::size_t>(link->index)];
    const double otherS = link->contactPoint == ContactPoint::end ? other.length : 0.0;
    const auto lanes = osgRoads::core::extentAt(road, s);
    const auto line = road.referenceLine.at(s), otherLine = other.referenceLine.at(otherS);
    double worst = 0.0;
    for (const double t : {lanes.rightT, 0.0, lanes.leftT})
    {
        const glm::dvec2 apart = line.position + t * leftOf(line) - otherLine.position;
        if (std::abs(glm::dot(apart, otherLine.tangent())) > kMostGapM) return 0.0; // a mistake in the file
        const double otherT = glm::dot(apart, leftOf(otherLine));
        worst = std::max(worst, std::abs(heightAt(index, s, t) - heightAt(link->index, otherS, otherT)));
    }
    return worst;
}

Worst worstOf(const RoadNetwork& network, const HeightAt& heightAt)
{
    Worst worst;
    for (int i = 0; i < static_cast<int>(network.roads.size()); ++i)
    {
        const Road& road = network.roads[static_cast<std::size_t>(i)];
        if (!road.isUsable) continue;
        if (road.junction >= 0)
            worst.junctionSlope = std::max(worst.junctionSlope, slopeOf(heightAt, i));
        else
            takeProfile(
                road.length, [&](double s) { return heightAt(i, s, 0.0); }, worst);
        for (const bool isEnd : {false, true})
            worst.joinM = std::max(worst.joinM, joinErrorM(network, heightAt, i, isEnd));
    }
    return worst;
}

Worst worstOf(const RoadNetwork& network, const GroundProfiles& profiles)
{
    return worstOf(network, heightsOf(network, profiles));
}

Worst worstOf(const std::shared_ptr<const RoadNetwork>& network, const foundation::HeightInPlan& ground,
              const GroundProfileLimits& limits = {})
{
    return worstOf(*network, laidOn(network, ground, limits));
}

} // namespace

/// Worked by hand. Smoothed by σ, which is 100 m and the width of the spline (40 m / √3), the ridge is 200 m
/// − 0.2 · E|x + σZ| high. Beside its crest, at x = qσ with q = 0.6745 (where half of all Z lie below), it
/// falls by 10 %; so does it at its foot, which lies at 0.2 · σ / √(2π). The lowest roads of 10 % that no
/// ground lies above pass through the one, 200 m − 0.2 · σ √(2/π) exp(−q²/2) − 0.1 · |x|, the highest that
/// none lies below through the other. The road is their mean: as deep in the ridge as high above the foot.
TEST(GroundProfiles, ARidgeIsCutAsDeepAsItsFootIsFilled)
{
    const auto network = overTheRidge();
    const GroundProfiles profiles = laidOn(network, ridgeM);
    const double sigmaM = std::hypot(100.0, 40.0 / std::sqrt(3.0)), q = 0.67449;
    const double footM = 0.2 * sigmaM / std::sqrt(2.0 * std::numbers::pi);
    const double raisedM = 200.0 - 0.2 * sigmaM * std::sqrt(2.0 / std::numbers::pi) * std::exp(-0.5 * q * q);
    const double topM = 0.5 * (raisedM + footM + 100.0), mostM = 0.5 * (raisedM - footM - 100.0);
    const auto roadM = [&](double x) { return heightM(*network, profiles, 0, 2000.0 + x); };
    EXPECT_NEAR(roadM(-500.0), topM - 50.0, 0.1);
    EXPECT_NEAR(roadM(500.0), topM - 50.0, 0.1);
    EXPECT_NEAR(roadM(1000.0) - profiles.ground().heightM({1000.0, 0.0}), mostM, 0.5) << "fill at the foot";
    EXPECT_NEAR(profiles.ground().heightM({q * sigmaM, 0.0}) - roadM(q * sigmaM), mostM, 0.5) << "cut";
    EXPECT_NEAR(roadM(400.0) - roadM(500.0), 10.0, 0.01);
    EXPECT_NEAR(roadM(2000.0), 0.0, 0.01) << "nothing is lifted on the plain";
}

TEST(GroundProfiles, TheRoadOverTheRidgeKeepsGradeAndRadius)
{
    const Worst worst = worstOf(overTheRidge(), ridgeM);
    EXPECT_TRUE(worst.keepsGrade()) << worst.grade;
    EXPECT_TRUE(worst.keepsRadius()) << 1.0 / worst.curvature;
    EXPECT_GT(worst.grade, 0.099) << "the ridge is steeper than the road may be";
}

TEST(GroundProfiles, ASteeperLimitAndShorterBendsAreSeen) // the test above can fail
{
    EXPECT_FALSE(worstOf(overTheRidge(), ridgeM, {.grade = 0.12}).keepsGrade());
    EXPECT_FALSE(worstOf(overTheRidge(), ridgeM, {.runInM = 0.0}).keepsRadius());
}

/// Worked by hand. The plane has 4 % where the ground has 8 %, and its middle, for reasons of symmetry, the
/// ground's height. Uphill of the middle the square's edge lies 0.04 · 10 m · cos 30° above it; 200 m farther
/// on the arm has the ground's height.
TEST(GroundProfiles, ACrossingOnASlopeLiesInAGentlerPlane)
{
    const auto network = crossing();
    const GroundProfiles profiles = laidOn(network, slopeM);
    const double cosine = std::sqrt(0.75);
    EXPECT_NEAR(heightM(*network, profiles, 4, 10.0), 0.0, 0.01) << "the middle";
    EXPECT_NEAR(heightM(*network, profiles, 0, 0.0), 0.04 * 10.0 * cosine, 0.01);
    EXPECT_NEAR(heightM(*network, profiles, 2, 0.0), -0.04 * 10.0 * cosine, 0.01);
    EXPECT_NEAR(heightM(*network, profiles, 1, 0.0), -0.04 * 10.0 * 0.5, 0.01);
    EXPECT_NEAR(heightM(*network, profiles, 0, 15.0) - heightM(*network, profiles, 0, 0.0),
                0.04 * 15.0 * cosine, 0.15)
        << "the run-in begins in the plane";
    EXPECT_NEAR(heightM(*network, profiles, 0, 250.0), 0.08 * 260.0 * cosine, 0.01);
    EXPECT_NEAR(slopeOf(heightsOf(*network, profiles), 4), 0.04, 1e-9);
}

TEST(GroundProfiles, TheCrossingKeepsEveryLimit)
{
    const Worst worst = worstOf(crossing(), slopeM);
    EXPECT_TRUE(worst.keepsGrade()) << worst.grade;
    EXPECT_TRUE(worst.keepsRadius()) << 1.0 / worst.curvature;
    EXPECT_TRUE(worst.keepsJunctions()) << worst.junctionSlope;
    EXPECT_LT(worst.joinM, 1e-9);
}

TEST(GroundProfiles, ASteeperJunctionAndRoadsThatDoNotTurnIntoItAreSeen) // the test above can fail
{
    EXPECT_FALSE(worstOf(crossing(), slopeM, {.junctionSlope = 0.06}).keepsJunctions());
    EXPECT_FALSE(worstOf(crossing(), slopeM, {.runInM = 0.0}).keepsJoins());
}

TEST(GroundProfiles, RoadsThatFollowEachOtherHaveOneProfileWhicheverWayTheyRun)
{
    const auto two =
        networkOf(StraightRoad{.id = 1,
                               .x = -2000.0,
                               .lengthM = 2100.0,
                               .links = R"(<successor elementType="road" contactPoint="end" elementId="2"/>)"}
                      .text() +
                  StraightRoad{.id = 2,
                               .x = 2000.0,
                               .headingRad = 3.141592653589793,
                               .lengthM = 1900.0,
                               .links = R"(<successor elementType="road" contactPoint="end" elementId="1"/>)"}
                      .text());
    const auto one = overTheRidge();
    const GroundProfiles parts = laidOn(two, ridgeM), whole = laidOn(one, ridgeM);
    EXPECT_LT(worstOf(*two, parts).joinM, 1e-9);
    for (double x = -1990.0; x < 2000.0; x += 130.0)
        EXPECT_NEAR(x < 100.0 ? heightM(*two, parts, 0, x + 2000.0) : heightM(*two, parts, 1, 2000.0 - x),
                    heightM(*one, whole, 0, x + 2000.0), 1e-6);
}

/// Real networks at a stated origin on hills of New Hampshire, 90 m a sample.
class GroundProfilesOnHills : public testing::TestWithParam<const char*>
{
};

TEST_P(GroundProfilesOnHills, KeepEveryLimit)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, "dem/N44W072.hgt");
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "openscenario/esmini/xodr");
    using namespace osgTerrainROAM::core;
    const auto description = describeTerrain(dem, {});
    ASSERT_TRUE(description);
    const auto tile = loadTile(*description);
    ASSERT_TRUE(tile) << tile.error().message();
    scenery::RoadsRequest request{folder / (std::string(GetParam()) + ".xodr"),
                                  scenery::RoadOrigin{44.35, -71.53, 0.0}, scenery::RoadHeights::ground};
    const auto roads = scenery::placeRoads(request, *tile);
    ASSERT_TRUE(roads) << roads.error().message();
    const auto& placed = *roads->placed;
    const RoadNetwork& network = placed.network();
    double cutM = 0.0, fillM = 0.0;
    for (int i = 0; i < static_cast<int>(network.roads.size()); ++i)
        for (double s = 0.0; s <= placed.road(i).length; s += 1.0)
        {
            const glm::dvec3 place = placed.point({i, s, 0.0, 0.0});
            const double aboveM = place.z - groundAt(*tile, place.x, place.y)->position.z;
            fillM = std::max(fillM, aboveM);
            cutM = std::max(cutM, -aboveM);
        }
    const Worst worst = worstOf(network,
                                [&](int road, double s, double t) {
                                    return tile->frame().heightOf(placed.point({road, s, t, 0.0}));
                                });
    std::cout << GetParam() << ": grade " << worst.grade << ", junction slope " << worst.junctionSlope
              << ", radius " << 1.0 / worst.curvature << " m, joins " << worst.joinM << " m, cut " << cutM
              << " m, fill " << fillM << " m\n";
    EXPECT_LE(worst.grade, kMostGrade + kMapM);
    EXPECT_LE(worst.junctionSlope, kMostJunctionSlope + kMapM);
    EXPECT_TRUE(worst.keepsJoins());
    EXPECT_LE(worst.curvature, 1.0 / kLeastShortRadiusM);
}

INSTANTIATE_TEST_SUITE_P(Networks, GroundProfilesOnHills,
                         testing::Values("e6mini", "soderleden", "fabriksgatan", "multi_intersections"),
                         testsupport::AfterFile());
