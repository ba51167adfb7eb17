// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/driver/DriverPath.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{

namespace
{

constexpr double kBendM = 3.0; ///< before and after a point, over which its curvature is taken

double headingOf(const glm::dvec3& along)
{
    return std::atan2(along.y, along.x);
}

} // namespace

DriverPath::DriverPath(const std::vector<DriverPoint>& points, std::vector<DriverStop> stops)
    : _points(points), _stops(std::move(stops))
{
    _along.push_back(0.0);
    for (std::size_t i = 1; i < _points.size(); ++i)
        _along.push_back(_along.back() + glm::length(glm::dvec2(_points[i].place - _points[i - 1].place)));
    for (const double along : _along)
    {
        const double before = std::max(0.0, along - kBendM), after = std::min(lengthM(), along + kBendM);
        const glm::dvec3 in = placeAt(along) - placeAt(before), out = placeAt(after) - placeAt(along);
        const bool isInside = before < along && after > along;
        _curvature.push_back(isInside ? foundation::wrappedRad(headingOf(out) - headingOf(in)) /
                                            (0.5 * (after - before))
                                      : 0.0);
    }
}

std::size_t DriverPath::indexAt(double alongM) const
{
    const auto above = std::upper_bound(_along.begin(), _along.end(), alongM);
    const auto index = std::max<std::ptrdiff_t>(0, above - _along.begin() - 1);
    return std::min(static_cast<std::size_t>(index), _points.size() - 2);
}

double DriverPath::headingRadAt(double alongM) const
{
    const std::size_t i = indexAt(alongM);
    return headingOf(_points[i + 1].place - _points[i].place);
}

/// Beyond its ends the way goes on straight.
glm::dvec3 DriverPath::placeAt(double alongM, double offsetM) const
{
    const std::size_t i = indexAt(alongM);
    const glm::dvec3 piece = _points[i + 1].place - _points[i].place;
    const double length = _along[i + 1] - _along[i];
    const glm::dvec3 left = glm::dvec3(-piece.y, piece.x, 0.0) / length;
    return _points[i].place + (alongM - _along[i]) / length * piece + offsetM * left;
}

DriverPath::Beside DriverPath::nearest(const glm::dvec3& place, double aboutM, double reachM) const
{
    Beside found{aboutM, 0.0};
    double least = 1e300;
    const std::size_t last = indexAt(aboutM + reachM);
    for (std::size_t i = indexAt(aboutM - reachM); i <= last; ++i)
    {
        const glm::dvec2 from(_points[i].place), piece = glm::dvec2(_points[i + 1].place) - from;
        const glm::dvec2 to = glm::dvec2(place) - from;
        const double length = _along[i + 1] - _along[i];
        const bool isEnd = i + 2 == _points.size(), isStart = i == 0;
        const double share =
            std::clamp(glm::dot(to, piece) / (length * length), isStart ? -1e6 : 0.0, isEnd ? 1e6 : 1.0);
        const glm::dvec2 apart = to - share * piece;
        const double square = glm::dot(apart, apart);
        if (square >= least) continue;
        least = square;
        found = {_along[i] + share * length, (piece.x * to.y - piece.y * to.x) / length};
    }
    return found;
}

} // namespace simulation
