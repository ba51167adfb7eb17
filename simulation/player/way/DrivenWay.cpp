// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/way/DrivenWay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include "simulation/road/RoadWalk.h"
#include "simulation/road/SpeedLimit.h"
#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

constexpr double kWayPointM = 2.0;
constexpr double kWayAheadM = 130.0, kWayChunkM = 30.0, kWayBehindM = 40.0;

/// Of a car in a bend and before it, chosen so that nobody in it is pushed about.
constexpr double kBendMps2 = 2.0, kWayGentleMps2 = 1.5, kBendSlowestMps = 2.5;

constexpr double kWithoutLimitMps = 50.0 / 3.6; ///< where no limit is told

/// Whether a road through a junction leads back, for one who came with a heading.
bool turnsBack(const osgRoads::core::Road& road, bool isForward, double cameRad)
{
    constexpr double kBackRad = 2.4;
    if (road.junction < 0) return false;
    const double leavesRad = road.referenceLine.at(isForward ? road.length : 0.0).headingRad +
                             (isForward ? 0.0 : std::numbers::pi);
    return std::fabs(foundation::wrappedRad(leavesRad - cameRad)) > kBackRad;
}

double wayLimitAt(const RoadScene& roads, const RoadPlace& place)
{
    return speedLimitAt(roads, place).value_or(kWithoutLimitMps);
}

} // namespace

bool DrivenWay::follow(EntityMotion& motion)
{
    const EntityState& state = motion.state();
    if (!state.place || state.place->road < 0) return false;
    if (_points.empty() || !findPlace(state.position)) begin(motion);
    if (_way.front() != state.place->road)
        if (const auto here = std::find(_way.begin(), _way.end(), state.place->road); here != _way.end())
        {
            _tailRoad -= std::min(_tailRoad, static_cast<std::size_t>(here - _way.begin()));
            _way.erase(_way.begin(), here);
            motion.setWay(_way);
        }
    if (!_hasEnded && _points.back().alongM < _alongM + kWayAheadM)
    {
        forget();
        lookAhead(motion);
        findLimits();
    }
    return true;
}

void DrivenWay::begin(EntityMotion& motion)
{
    const RoadPlace& place = *motion.state().place;
    _points.clear();
    _crossings.clear();
    _lines.clear();
    _hasEnded = false;
    _at = 0;
    _tailRoad = 0;
    RoadWay known = motion.way();
    const auto here = std::find(known.begin(), known.end(), place.road);
    known.erase(known.begin(), here);
    _way = known.empty() ? RoadWay{place.road} : std::move(known);
    _tail = place;
    _tail.relativeHeadingRad = looksForward(place) ? 0.0 : std::numbers::pi;
    add(_tail);
    _points.back().alongM = _alongM;
    const auto lane = _table->meetings().laneAt(_tail);
    if (lane)
        addCrossings(_tail, _alongM - _table->meetings().alongM(*lane, glm::dvec2(_points.back().place)));
}

/// The junction on whose road a place lies, or the narrow stretches there. `laneM`: where its lane begins.
void DrivenWay::addCrossings(const RoadPlace& place, double laneM)
{
    constexpr double kFrontM = 3.5; ///< of a car, before its rear axle
    const auto lane = _table->meetings().laneAt(place);
    if (!lane) return;
    const auto& met = _table->meetings().metBy(*lane);
    if (const int junction = _table->junctionOf(place.road); junction >= 0)
    {
        _crossings.push_back({*lane, laneM, 1e300, 0.0, false, junction, met.empty() ? nullptr : &met});
        return;
    }
    for (const LaneStretch& stretch : _table->meetings().narrowOn(*lane))
    {
        const double lengthM = stretch.toM - stretch.fromM, aheadM = std::min(kFrontM, lengthM);
        if (laneM + stretch.toM < _alongM) continue;
        _crossings.push_back({*lane, laneM + stretch.fromM + aheadM, laneM + stretch.toM,
                              stretch.fromM + aheadM, true, -1, &met});
    }
}

/// Goes on along the points. False: the entity is not on them.
bool DrivenWay::findPlace(const glm::dvec3& position)
{
    constexpr double kOffM = 6.0;
    const auto apart = [&](std::size_t i)
    {
        const glm::dvec2 between(_points[i].place - position);
        return glm::dot(between, between);
    };
    while (_at + 1 < _points.size() && apart(_at + 1) <= apart(_at))
        ++_at;
    if (apart(_at) > kOffM * kOffM) return false;
    const Point& point = _points[_at];
    const glm::dvec2 ahead(std::cos(point.headingRad), std::sin(point.headingRad));
    _alongM = point.alongM + glm::dot(glm::dvec2(position - point.place), ahead);
    return true;
}

double DrivenWay::allowedMps() const
{
    const Point& here = _points[_at];
    if (_at + 1 == _points.size()) return here.allowedMps;
    return std::min(here.allowedMps, _points[_at + 1].allowedMps);
}

void DrivenWay::forget()
{
    std::size_t old = 0;
    while (old < _at && _points[old].alongM < _alongM - kWayBehindM)
        ++old;
    _points.erase(_points.begin(), _points.begin() + static_cast<std::ptrdiff_t>(old));
    _at -= old;
    std::erase_if(_crossings, [&](const Crossing& crossing) { return crossing.toM < _alongM - kWayBehindM; });
    std::erase_if(_lines, [&](const Line& line) { return line.alongM < _alongM - kWayBehindM; });
}

void DrivenWay::lookAhead(EntityMotion& motion)
{
    const double untilM = _alongM + kWayAheadM + kWayChunkM;
    while (_points.back().alongM < untilM)
    {
        const RoadPlace before = _tail;
        const double restM = looksForward(_tail) ? _table->roads().roadAt(_tail).length - _tail.s : _tail.s;
        if (restM < 3.0 * kWayPointM) choose(motion);
        const RoadWay ahead(_way.begin() + static_cast<std::ptrdiff_t>(_tailRoad), _way.end());
        if (!walk(_table->roads(), _tail, kWayPointM, ahead))
        {
            _hasEnded = true;
            return;
        }
        add(_tail);
        addLines(before);
        if (before.road == _tail.road && looksForward(before) == looksForward(_tail)) continue;
        const double alongM = _points.back().alongM;
        const double borderM =
            alongM - std::min(kWayPointM,
                              looksForward(_tail) ? _tail.s : _table->roads().roadAt(_tail).length - _tail.s);
        for (Crossing& crossing : _crossings)
            if (crossing.toM > 1e299) crossing.toM = borderM;
        const auto next =
            std::find(_way.begin() + static_cast<std::ptrdiff_t>(_tailRoad), _way.end(), _tail.road);
        if (next == _way.end()) // it went a way that nobody chose
        {
            _way.resize(_tailRoad + 1);
            _way.push_back(_tail.road);
            _tailRoad = _way.size() - 1;
        }
        else
            _tailRoad = static_cast<std::size_t>(next - _way.begin());
        addCrossings(_tail, borderM);
    }
}

/// Draws the roads that follow the last ones of the way, up to one that is no short one.
void DrivenWay::choose(EntityMotion& motion)
{
    if (!_draw) return;
    const osgRoads::core::RoadNetwork& network = _table->roads().network();
    bool isForward = looksForward(_tail);
    int lane = _tail.lane;
    bool hasGrown = false;
    double knownM = 0.0;
    const double cameRad = headingBeforeJunctions();
    for (std::size_t i = _tailRoad; knownM < 4.0 * kWayPointM; ++i)
    {
        std::vector<RoadStep> steps = stepsFrom(network, _way[i], isForward, lane);
        if (steps.empty()) break;
        const RoadStep* taken = &steps.front();
        if (i + 1 < _way.size())
        {
            for (const RoadStep& step : steps)
                if (step.road == _way[i + 1]) taken = &step;
        }
        else
        {
            std::vector<double> weights;
            for (const RoadStep& step : steps)
            {
                const bool leadsOn = _table->leadsOn({step.road, step.lane, step.entersAtStart});
                const bool isKnown = std::find(_way.begin(), _way.end(), step.road) != _way.end();
                const bool isBack = turnsBack(network.roads[static_cast<std::size_t>(step.road)],
                                              step.entersAtStart, cameRad);
                weights.push_back((leadsOn ? 1.0 : 1e-6) * (isKnown || isBack ? 1e-3 : 1.0));
            }
            taken = &steps[_draw->index(weights)];
            _way.push_back(taken->road);
            hasGrown = true;
        }
        isForward = taken->entersAtStart;
        lane = taken->lane;
        knownM += network.roads[static_cast<std::size_t>(taken->road)].length;
    }
    if (hasGrown) motion.setWay(_way);
}

/// With which it comes to the next junction, or came to the first of those that lie close together before it.
double DrivenWay::headingBeforeJunctions() const
{
    constexpr double kCloseM = 15.0;
    double fromM = _points.back().alongM;
    for (auto crossing = _crossings.rbegin(); crossing != _crossings.rend(); ++crossing)
    {
        if (crossing->isNarrow) continue;
        if (crossing->toM < fromM - kCloseM) break;
        fromM = crossing->fromM;
    }
    const auto behind = std::find_if(_points.rbegin(), _points.rend(),
                                     [&](const Point& point) { return point.alongM <= fromM; });
    return behind == _points.rend() ? _points.front().headingRad : behind->headingRad;
}

void DrivenWay::add(const RoadPlace& place)
{
    const RoadPose pose = _table->roads().poseAt(place);
    Point point{pose.position,
                0.0,
                pose.headingRad,
                {std::cos(pose.headingRad), std::sin(pose.headingRad)},
                wayLimitAt(_table->roads(), place),
                0.0};
    if (!_points.empty())
        point.alongM =
            _points.back().alongM + glm::distance(glm::dvec2(point.place), glm::dvec2(_points.back().place));
    _points.push_back(point);
}

/// The lines between the last point and the one before it.
void DrivenWay::addLines(const RoadPlace& before)
{
    const double alongM = _points[_points.size() - 2].alongM;
    const RoadScene& roads = _table->roads();
    if (before.road == _tail.road && looksForward(before) == looksForward(_tail))
    {
        addLinesOn(before, before.s, _tail.s, alongM);
        return;
    }
    const double endM = looksForward(before) ? roads.roadAt(before).length : 0.0;
    addLinesOn(before, before.s, endM, alongM);
    const double startM = looksForward(_tail) ? 0.0 : roads.roadAt(_tail).length;
    addLinesOn(_tail, startM, _tail.s, alongM + std::fabs(endM - before.s));
}

void DrivenWay::addLinesOn(const RoadPlace& place, double fromM, double toM, double alongM)
{
    constexpr double kSameM = 0.1;
    const osgRoads::core::Road& road = _table->roads().roadAt(place);
    if (road.signals.empty() && road.signalReferences.empty()) return;
    for (const RoadStop& stop : stopsBetween(_table->roads().network(), place.road, place.lane, fromM, toM))
    {
        const Line line{alongM + std::fabs(stop.sM - fromM), stop.signal};
        // One at a point of the way is between that and both of its neighbours.
        const bool isKnown = std::any_of(_lines.begin(), _lines.end(),
                                         [&](const Line& known) {
                                             return known.light == line.light &&
                                                    std::fabs(known.alongM - line.alongM) < kSameM;
                                         });
        if (!isKnown) _lines.push_back(line);
    }
}

void DrivenWay::findLimits()
{
    constexpr std::size_t kApart = 2;
    const std::size_t count = _points.size();
    for (std::size_t i = count; i-- > 0;)
    {
        Point& point = _points[i];
        double limit = point.limitMps;
        if (i >= kApart && i + kApart < count)
        {
            const Point &before = _points[i - kApart], &after = _points[i + kApart];
            const double turn = std::fabs(foundation::wrappedRad(after.headingRad - before.headingRad));
            const double bend = turn / std::max(after.alongM - before.alongM, 1.0);
            limit = std::min(limit, std::max(kBendSlowestMps, std::sqrt(kBendMps2 / std::max(bend, 1e-9))));
        }
        point.allowedMps = limit;
        if (i + 1 == count) continue;
        const Point& next = _points[i + 1];
        const double ahead = std::sqrt(next.allowedMps * next.allowedMps +
                                       2.0 * kWayGentleMps2 * (next.alongM - point.alongM));
        point.allowedMps = std::min(limit, ahead);
    }
}

} // namespace simulation
