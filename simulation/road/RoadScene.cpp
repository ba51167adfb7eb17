// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/RoadScene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <foundation/Angle.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/read/ReadNetwork.h>

namespace simulation
{
namespace
{

using osgRoads::core::Lane;
using osgRoads::core::LaneSection;
using osgRoads::core::LaneSpan;
using osgRoads::core::Road;

constexpr double kAngleStepM = 0.05; ///< of the difference that gives the direction of a lane's middle

/// Returns the slope of the middle of a lane over s: widths that change turn the lane.
double laneSlope(const Road& road, const RoadPlace& place)
{
    const LaneSection* const section = osgRoads::core::sectionAt(road, place.s);
    if (!section || place.lane == 0) return road.laneOffset.slope(place.s);
    const double from = std::max(section->s, place.s - kAngleStepM);
    const double to = std::min(section->end - 1e-9, place.s + kAngleStepM);
    const auto first = osgRoads::core::laneSpan(road, place.lane, from);
    const auto last = osgRoads::core::laneSpan(road, place.lane, to);
    if (!first || !last || !(to > from)) return 0.0;
    return (last->centreT() - first->centreT()) / (to - from);
}

/// Returns the angle in the plan view between what goes along a lane and the reference line. A bank that
/// changes moves the lane sideways, too: the distance from the reference line is t times the cosine of the
/// bank.
double laneAngle(const Road& road, const RoadPlace& place)
{
    const double slope = laneSlope(road, place);
    if (!road.hasTilt()) return std::atan(slope);
    const double bank = road.superelevationRad.value(place.s);
    return std::atan(slope * std::cos(bank) -
                     place.t * std::sin(bank) * road.superelevationRad.slope(place.s));
}

/// Whether wheels belong on a lane of this type: everything but ground beside the road.
bool carriesTraffic(osgRoads::core::LaneType type)
{
    using osgRoads::core::LaneType;
    return type != LaneType::none && type != LaneType::restricted && type != LaneType::median;
}

/// Who is on the strip between a road and its sidewalk belongs to the sidewalk, as in esmini.
void leaveKerb(const Road& road, RoadPlace& place)
{
    using osgRoads::core::LaneType;
    const auto kerb = osgRoads::core::laneSpan(road, place.lane, place.s);
    if (!kerb || (kerb->lane->type != LaneType::border && kerb->lane->type != LaneType::curb)) return;
    const int beside = place.lane + (place.lane > 0 ? 1 : -1);
    const auto walk = osgRoads::core::laneSpan(road, beside, place.s);
    if (!walk || walk->lane->type != LaneType::sidewalk || walk->width() <= 0.0) return;
    place.lane = beside;
    place.laneOffsetM = place.t - walk->centreT();
}

/// The height of the surface at a place. Who belongs to a sidewalk is as high as it is, on the kerb beside
/// it, too.
double heightAt(const Road& road, const RoadPlace& place)
{
    constexpr double kInsideM = 1e-6;
    const auto span = osgRoads::core::laneSpan(road, place.lane, place.s);
    double t = place.t;
    if (span && span->lane->type == osgRoads::core::LaneType::sidewalk && span->width() > 2.0 * kInsideM)
        t = std::clamp(t, std::min(span->innerT, span->outerT) + kInsideM,
                       std::max(span->innerT, span->outerT) - kInsideM);
    return osgRoads::core::surfaceHeight(road, place.s, t);
}

std::vector<foundation::Error> mistakesOf(const osgRoads::core::ReadNetwork& read, const std::string& file)
{
    constexpr std::size_t kMost = 10;
    std::vector<foundation::Error> mistakes;
    std::size_t more = read.mistakesNotListed;
    for (const osgRoads::core::Problem& problem : read.problems)
    {
        if (problem.kind != osgRoads::core::ProblemKind::mistake) continue;
        if (mistakes.size() == kMost)
            ++more;
        else
            mistakes.push_back(
                {file + ":" + std::to_string(problem.line),
                 problem.what + (problem.count > 1 ? " (" + std::to_string(problem.count) + " times)" : ""),
                 problem.remedy});
    }
    if (more > 0)
        mistakes.push_back(
            {file, std::to_string(more) + " more such lines", "roadtool validate tells them all"});
    return mistakes;
}

} // namespace

foundation::Result<std::shared_ptr<const RoadScene>> RoadScene::open(const std::filesystem::path& file)
{
    auto read = osgRoads::core::readNetwork(file);
    if (!read) return read.error();
    return std::make_shared<const RoadScene>(std::move(read->network), mistakesOf(*read, file.string()));
}

RoadScene::RoadScene(osgRoads::core::RoadNetwork network, std::vector<foundation::Error> mistakes)
    : _network(std::move(network)), _locator(_network), _mistakes(std::move(mistakes))
{
}

std::optional<RoadPlace> RoadScene::onLane(const std::string& roadId, int lane, double s,
                                           double offsetM) const
{
    RoadPlace place;
    place.road = _network.roadIndex(roadId);
    if (place.road < 0 || !roadAt(place).isUsable) return std::nullopt;
    place.s = std::clamp(s, 0.0, roadAt(place).length);
    if (!putOnLane(place, lane, offsetM)) return std::nullopt;
    return looking(place);
}

std::optional<RoadPlace> RoadScene::onTrack(const std::string& roadId, double s, double t) const
{
    RoadPlace place;
    place.road = _network.roadIndex(roadId);
    if (place.road < 0 || !roadAt(place).isUsable) return std::nullopt;
    place.s = std::clamp(s, 0.0, roadAt(place).length);
    place.t = t;
    takeNearestLane(place);
    return looking(place);
}

std::optional<RoadPlace> RoadScene::nearest(const glm::dvec3& point, double headingRad) const
{
    const auto match = _locator.nearest(point);
    if (!match) return std::nullopt;
    RoadPlace place;
    place.road = match->position.road;
    place.s = match->position.s;
    place.t = match->position.t;
    takeNearestLane(place);
    place.heightM = point.z - poseAt(place).position.z;
    place.relativeHeadingRad = foundation::wrappedRad(headingRad - poseAt(place).headingRad);
    return place;
}

RoadPose RoadScene::poseAt(const RoadPlace& place) const
{
    const Road& road = roadAt(place);
    // What turns in the plane of the road turns less, seen from above, where the road is banked.
    const double turn = place.relativeHeadingRad;
    const double seen =
        road.hasTilt()
            ? std::atan2(std::sin(turn) * std::cos(road.superelevationRad.value(place.s)), std::cos(turn))
            : turn;
    const double turned = seen + laneAngle(road, place);
    const osgRoads::core::WorldPose pose =
        osgRoads::core::worldPose(_network, {place.road, place.s, place.t, heightAt(road, place)}, turned);
    return {pose.position + glm::dvec3(0.0, 0.0, place.heightM), pose.headingRad, -pose.pitchRad,
            pose.rollRad};
}

bool RoadScene::putOnLane(RoadPlace& place, int lane, double offsetM) const
{
    const Road& road = roadAt(place);
    double centreT = road.laneOffset.value(place.s);
    if (lane != 0)
    {
        const auto span = osgRoads::core::laneSpan(road, lane, place.s);
        if (!span) return false;
        centreT = span->centreT();
    }
    place.lane = lane;
    place.laneOffsetM = offsetM;
    place.t = centreT + offsetM;
    place.curvature = road.referenceLine.at(place.s).curvature;
    return true;
}

void RoadScene::takeNearestLane(RoadPlace& place) const
{
    const Road& road = roadAt(place);
    place.curvature = road.referenceLine.at(place.s).curvature;
    place.lane = 0;
    place.laneOffsetM = place.t - road.laneOffset.value(place.s);
    const LaneSection* const section = osgRoads::core::sectionAt(road, place.s);
    if (!section) return;
    double least = std::numeric_limits<double>::infinity();
    for (const int sign : {-1, 1})
        osgRoads::core::forLanesOutwards(road, *section, sign, place.s,
                                         [&](const LaneSpan& span)
                                         {
                                             const double beside =
                                                 std::fabs(place.t - span.centreT()) - 0.5 * span.width();
                                             if (span.width() <= 0.0 || beside >= least) return true;
                                             least = std::max(beside, 0.0);
                                             place.lane = span.lane->id;
                                             place.laneOffsetM = place.t - span.centreT();
                                             return true;
                                         });
    leaveKerb(road, place);
}

bool RoadScene::takeLaneAhead(RoadPlace& place) const
{
    constexpr double kOtherWayM = 1e6; ///< counts as so much farther
    const Road& road = roadAt(place);
    const LaneSection* const section = osgRoads::core::sectionAt(road, place.s);
    if (!section) return false;
    const bool looksForward = std::cos(place.relativeHeadingRad) >= 0.0;
    double least = std::numeric_limits<double>::infinity();
    int nearest = 0;
    for (const int sign : {-1, 1})
        osgRoads::core::forLanesOutwards(
            road, *section, sign, place.s,
            [&](const LaneSpan& span)
            {
                if (span.width() <= 0.0 || !carriesTraffic(span.lane->type)) return true;
                const bool isOther = osgRoads::core::runsForward(road, *span.lane) != looksForward;
                const double apart = std::fabs(place.t - span.centreT()) + (isOther ? kOtherWayM : 0.0);
                if (apart < least) nearest = span.lane->id;
                least = std::min(least, apart);
                return true;
            });
    if (nearest == 0 || !putOnLane(place, nearest, 0.0)) return false;
    place.relativeHeadingRad = looksForward ? 0.0 : std::numbers::pi;
    return true;
}

bool RoadScene::runsForward(const RoadPlace& place) const
{
    const Road& road = roadAt(place);
    const LaneSection* const section = osgRoads::core::sectionAt(road, place.s);
    const Lane* const lane = section && place.lane != 0 ? section->lane(place.lane) : nullptr;
    return !lane || osgRoads::core::runsForward(road, *lane);
}

bool RoadScene::isOffRoad(const RoadPlace& place, const glm::dvec3& position) const
{
    for (const auto& match : _locator.within(glm::dvec2(position), 1e-6))
        if (const auto span =
                osgRoads::core::laneAt(_network.roads[static_cast<std::size_t>(match.position.road)],
                                       match.position.s, match.position.t))
            if (carriesTraffic(span->lane->type)) return false;
    return place.road >= 0;
}

RoadPlace RoadScene::looking(RoadPlace place) const
{
    place.relativeHeadingRad = runsForward(place) ? 0.0 : std::numbers::pi;
    return place;
}

std::vector<int> RoadScene::roadsWithin(double distanceM, const glm::dvec2& point) const
{
    std::vector<int> roads;
    for (const auto& match : _locator.within(point, distanceM))
        roads.push_back(match.position.road);
    return roads;
}

} // namespace simulation
