// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/TrajectoryRun.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <foundation/NearestOnSegment.h>

namespace simulation
{
namespace
{

constexpr double kSameSpotM = 1e-9;
constexpr double kLargestTimeS = 1e9;
constexpr double kAheadM = 1.0; ///< between the places of pointsAhead()

std::vector<PathVertex> placedVertices(const FollowTrajectoryAction& action, const SceneFrame& frame)
{
    std::vector<PathVertex> vertices;
    for (const Vertex& vertex : std::get<Polyline>(action.trajectory.shape).vertices)
    {
        PathVertex placed{0.0, frame.place(vertex.position), orientationOf(vertex.position)};
        if (action.timing)
            placed.parameter = *vertex.timeS;
        else if (!vertices.empty())
        {
            const double chord = glm::length(placed.position - vertices.back().position);
            if (chord < kSameSpotM) continue;
            placed.parameter = vertices.back().parameter + chord;
        }
        vertices.push_back(placed);
    }
    return vertices;
}

/// From the last vertex back to the first: its length, or the time it takes at the mean speed of the rest.
double closingLength(const std::vector<PathVertex>& vertices, bool isTimed)
{
    const double gap =
        std::max(kSameSpotM, glm::length(vertices.front().position - vertices.back().position));
    if (!isTimed) return gap;
    double length = 0.0;
    for (std::size_t i = 1; i < vertices.size(); ++i)
        length += glm::length(vertices[i].position - vertices[i - 1].position);
    const double time = vertices.back().parameter - vertices.front().parameter;
    return length > 0.0 ? std::max(kSameSpotM, gap / length * time) : time;
}

PathCurve makeCurve(const FollowTrajectoryAction& action, const SceneFrame& frame, bool inPlan)
{
    std::vector<PathVertex> vertices = placedVertices(action, frame);
    std::optional<double> closing;
    if (action.trajectory.closed) closing = closingLength(vertices, action.timing.has_value());
    return {std::move(vertices), action.mode, closing, inPlan};
}

} // namespace

std::optional<std::string> TrajectoryRun::obstacle(const FollowTrajectoryAction& action,
                                                   const SceneFrame& frame)
{
    const auto* polyline = std::get_if<Polyline>(&action.trajectory.shape);
    if (!polyline) return "its shape is not supported";
    for (std::size_t i = 0; i < polyline->vertices.size(); ++i)
    {
        const Vertex& vertex = polyline->vertices[i];
        if (!frame.canPlace(vertex.position)) return "a vertex cannot be placed in this scene";
        if (!action.timing) continue;
        if (!vertex.timeS || !(std::fabs(*vertex.timeS) <= kLargestTimeS)) return "a vertex has no time";
        if (i > 0 && !Vertex::isLater(*polyline->vertices[i - 1].timeS, *vertex.timeS))
            return "its times do not rise";
        if (!Timing::isScale(action.timing->scale)) return "its time scale is not within 1e-6 and 1e6";
    }
    if (polyline->vertices.size() < 2 || placedVertices(action, frame).size() < 2)
        return "it has fewer than two different vertices";
    return std::nullopt;
}

TrajectoryRun::TrajectoryRun(const FollowTrajectoryAction& action, const SceneFrame& frame, double startTimeS,
                             bool inPlan)
    : _timing(action.timing),
      _startTimeS(startTimeS),
      _inPlan(inPlan),
      _curve(makeCurve(action, frame, inPlan)),
      _parameter(_curve.begin())
{
    const auto& polyline = std::get<Polyline>(action.trajectory.shape);
    _lengthM = _curve.isClosed() ? _curve.lengthM() : polyline.lengthM.value_or(_curve.lengthM());
    _distanceM =
        _curve.isClosed() ? action.initialDistanceOffsetM : std::min(action.initialDistanceOffsetM, _lengthM);
    _parameter = _curve.parameterAt(_lengthM > 0.0 ? _distanceM * _curve.lengthM() / _lengthM : 0.0);
    _timeOffset = _parameter - _curve.begin();
    if (_timing) advanceTo(startTimeS);
}

double TrajectoryRun::parameterAtTime(double timeS) const
{
    const double base = _timing->domain == Timing::Domain::relative ? _startTimeS : 0.0;
    return (timeS - base - _timing->offsetS) / _timing->scale + _timeOffset;
}

std::optional<double> TrajectoryRun::advanceTo(double timeS)
{
    const double wanted = parameterAtTime(timeS);
    _hasBegun = wanted >= _curve.begin();
    if (_curve.isClosed())
    {
        _parameter = std::max(wanted, _curve.begin());
        return std::nullopt;
    }
    _parameter = std::clamp(wanted, _curve.begin(), _curve.end());
    if (wanted < _curve.end()) return std::nullopt;
    return (wanted - _curve.end()) * _timing->scale;
}

std::optional<double> TrajectoryRun::advanceBy(double distanceM)
{
    _distanceM += distanceM;
    _parameter = _curve.parameterAt(_distanceM * _curve.lengthM() / _lengthM);
    if (_curve.isClosed() || _distanceM < _lengthM) return std::nullopt;
    return _distanceM - _lengthM;
}

std::vector<AheadPoint> TrajectoryRun::pointsAhead(double lengthM) const
{
    const double from = _curve.distanceAt(_parameter);
    const double to = _curve.isClosed() ? from + lengthM : std::min(from + lengthM, _curve.lengthM());
    std::vector<AheadPoint> points;
    for (double at = from; at < to; at += kAheadM)
        points.push_back({_curve.at(_curve.parameterAt(at)).position, std::nullopt});
    points.push_back({_curve.at(_curve.parameterAt(to)).position, std::nullopt});
    return points;
}

std::optional<double> TrajectoryRun::wayTo(const glm::dvec3& place) const
{
    constexpr double kFarthestM = 5.0;
    return wayTo(place, kFarthestM);
}

void TrajectoryRun::rejoin(const glm::dvec3& place, double timeS)
{
    constexpr double kAnywhereM = 1e9;
    const double way = wayTo(place, kAnywhereM).value_or(0.0);
    const double at = _curve.distanceAt(_parameter) + way;
    _parameter = _curve.parameterAt(_curve.isClosed() ? at : std::min(at, _curve.lengthM()));
    _hasBegun = true;
    if (_timing)
        _timeOffset += _parameter - parameterAtTime(timeS);
    else if (_curve.lengthM() > 0.0)
        _distanceM += way * _lengthM / _curve.lengthM();
}

std::optional<double> TrajectoryRun::wayTo(const glm::dvec3& place, double farthestM) const
{
    const double total = _curve.lengthM() - (_curve.isClosed() ? 0.0 : _curve.distanceAt(_parameter));
    double nearest = farthestM;
    std::optional<double> way;
    const std::vector<AheadPoint> points = pointsAhead(total);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
        const glm::dvec2 from(points[i].place), along = glm::dvec2(points[i + 1].place) - from;
        const double share =
            foundation::nearestShare(glm::dvec2(place), from, glm::dvec2(points[i + 1].place));
        const double distance = glm::distance(glm::dvec2(place), from + along * share);
        if (distance >= nearest) continue;
        nearest = distance;
        const double begin = kAheadM * static_cast<double>(i);
        way = begin + share * std::min(kAheadM, total - begin);
    }
    return way;
}

double TrajectoryRun::timedSpeedMps() const
{
    if (!_hasBegun) return 0.0;
    const glm::dvec3 along = _curve.at(_parameter).tangent;
    return (_inPlan ? std::hypot(along.x, along.y) : glm::length(along)) / _timing->scale;
}

} // namespace simulation
