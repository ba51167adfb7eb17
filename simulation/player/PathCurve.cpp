// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/PathCurve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "simulation/player/PathHeadings.h"

namespace simulation
{
namespace
{

constexpr std::size_t kWrapVertices = 8;    ///< a spline forgets a knot by a factor of 0.27 per knot
constexpr std::size_t kTableDivisions = 32; ///< of a curved segment, in the table of distances
constexpr double kStandstillM = 1e-9;

/// Continues a closed path over its own ends, so that the natural spline inside is nearly periodic.
std::vector<PathVertex> wrappedVertices(const std::vector<PathVertex>& vertices, double period)
{
    const std::size_t count = vertices.size();
    std::vector<PathVertex> wrapped;
    const auto append = [&](std::size_t index, double shift)
    {
        wrapped.push_back(vertices[index % count]);
        const std::size_t round = index / count;
        wrapped.back().parameter += shift + period * static_cast<double>(round);
    };
    const std::size_t rounds = (kWrapVertices + count - 1) / count;
    for (std::size_t i = 0; i < count * (2 * rounds + 1); ++i)
        append(i, -period * static_cast<double>(rounds));
    wrapped.push_back(vertices.front());
    wrapped.back().parameter += period * static_cast<double>(rounds + 1);
    return wrapped;
}

template<class Get>
std::vector<double> collect(const std::vector<PathVertex>& vertices, Get get)
{
    std::vector<double> values;
    values.reserve(vertices.size());
    for (const PathVertex& vertex : vertices)
        values.push_back(get(vertex));
    return values;
}

} // namespace

double PathPoint::planCurvature() const
{
    const double speed2 = tangent.x * tangent.x + tangent.y * tangent.y;
    if (speed2 < kStandstillM * kStandstillM) return 0.0;
    return (tangent.x * bend.y - tangent.y * bend.x) / (speed2 * std::sqrt(speed2));
}

PathCurve::PathCurve(std::vector<PathVertex> vertices, FollowingMode mode,
                     std::optional<double> closingLength, bool inPlan)
    : _mode(mode),
      _closed(closingLength.has_value()),
      _inPlan(inPlan),
      _begin(vertices.front().parameter),
      _end(vertices.back().parameter + closingLength.value_or(0.0))
{
    assert(vertices.size() >= 2);
    if (_closed) vertices = wrappedVertices(vertices, _end - _begin);
    const CubicSpline::Kind kind =
        mode == FollowingMode::follow ? CubicSpline::Kind::natural : CubicSpline::Kind::linear;
    const std::vector<double> knots = collect(vertices, [](const PathVertex& v) { return v.parameter; });
    _x = CubicSpline(knots, collect(vertices, [](const PathVertex& v) { return v.position.x; }), kind);
    _y = CubicSpline(knots, collect(vertices, [](const PathVertex& v) { return v.position.y; }), kind);
    _z = CubicSpline(knots, collect(vertices, [](const PathVertex& v) { return v.position.z; }), kind);
    buildAngles(vertices);
    buildDistances();
}

void PathCurve::buildAngles(const std::vector<PathVertex>& vertices)
{
    const CubicSpline::Kind kind =
        _mode == FollowingMode::follow ? CubicSpline::Kind::natural : CubicSpline::Kind::linear;
    _pitch = vertexAngles(vertices, &Orientation::pitchRad, kind);
    _roll = vertexAngles(vertices, &Orientation::rollRad, kind);
    const bool isGiven =
        std::all_of(vertices.begin(), vertices.end(),
                    [](const PathVertex& vertex) { return vertex.orientation.headingRad.has_value(); });
    if (_mode == FollowingMode::follow || (_mode == FollowingMode::straight && isGiven))
        _heading = vertexAngles(vertices, &Orientation::headingRad, kind);
    else if (isGiven)
        _heading = givenHeadings(vertices);
    else
        _heading = segmentHeadings(vertices);
}

/// Distances at the knots, and inside the segments of a spline, where each small piece is measured with
/// Simpson's rule on the speed.
void PathCurve::buildDistances()
{
    const auto speedAt = [this](double u)
    { return glm::length(glm::dvec3(_x.at(u).first, _y.at(u).first, _inPlan ? 0.0 : _z.at(u).first)); };
    const std::size_t divisions = _mode == FollowingMode::follow ? kTableDivisions : 1;
    _parameters = {_begin};
    _distances = {0.0};
    const std::vector<double>& knots = _x.knots();
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    {
        if (knots[i] < _begin || knots[i + 1] > _end) continue;
        const double width = (knots[i + 1] - knots[i]) / static_cast<double>(divisions);
        for (std::size_t k = 0; k < divisions; ++k)
        {
            const double from = knots[i] + width * static_cast<double>(k);
            const double middle = speedAt(from + 0.5 * width);
            const double mean =
                divisions == 1 ? middle : (speedAt(from) + 4.0 * middle + speedAt(from + width)) / 6.0;
            _parameters.push_back(k + 1 == divisions ? knots[i + 1] : from + width);
            _distances.push_back(_distances.back() + mean * width);
        }
    }
    _parameters.back() = _end;
}

double PathCurve::wrapped(double parameter) const
{
    if (!_closed) return std::clamp(parameter, _begin, _end);
    const double period = _end - _begin;
    const double rest = std::fmod(parameter - _begin, period);
    return _begin + (rest < 0.0 ? rest + period : rest);
}

PathPoint PathCurve::at(double parameter) const
{
    const double u = wrapped(parameter);
    const CubicSpline::Sample x = _x.at(u);
    const CubicSpline::Sample y = _y.at(u);
    const CubicSpline::Sample z = _z.at(u);
    PathPoint point;
    point.position = {x.value, y.value, z.value};
    point.tangent = {x.first, y.first, z.first};
    point.bend = {x.second, y.second, z.second};
    if (_heading)
        point.headingRad = _heading->at(u).value;
    else if (std::hypot(point.tangent.x, point.tangent.y) > kStandstillM)
        point.headingRad = std::atan2(point.tangent.y, point.tangent.x);
    if (_pitch) point.pitchRad = _pitch->at(u).value;
    if (_roll) point.rollRad = _roll->at(u).value;
    return point;
}

double PathCurve::distanceAt(double parameter) const
{
    const double u = wrapped(parameter);
    const auto above = std::upper_bound(_parameters.begin(), _parameters.end(), u);
    if (above == _parameters.begin()) return 0.0;
    if (above == _parameters.end()) return _distances.back();
    const auto i = static_cast<std::size_t>(above - _parameters.begin());
    const double share = (u - _parameters[i - 1]) / (_parameters[i] - _parameters[i - 1]);
    return _distances[i - 1] + share * (_distances[i] - _distances[i - 1]);
}

double PathCurve::parameterAt(double distanceM) const
{
    double distance = std::clamp(distanceM, 0.0, lengthM());
    if (_closed && lengthM() > 0.0)
    {
        distance = std::fmod(distanceM, lengthM());
        if (distance < 0.0) distance += lengthM();
    }
    const auto above = std::upper_bound(_distances.begin(), _distances.end(), distance);
    if (above == _distances.end()) return _end;
    const auto i = static_cast<std::size_t>(above - _distances.begin());
    if (i == 0) return _begin;
    const double share = (distance - _distances[i - 1]) / (_distances[i] - _distances[i - 1]);
    return _parameters[i - 1] + share * (_parameters[i] - _parameters[i - 1]);
}

} // namespace simulation
