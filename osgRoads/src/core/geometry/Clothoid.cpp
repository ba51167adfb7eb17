// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 9.5 (spiral).
#include <algorithm>
#include <cmath>

#include <osgRoads/core/geometry/Clothoid.h>
#include <osgRoads/core/geometry/GaussLegendre.h>

namespace osgRoads::core
{

namespace
{

constexpr double kTurnOfPanelRad = 0.5;

} // namespace

Clothoid::Clothoid(double curvatureAtStart, double curvatureAtEnd, double length)
    : _curvature(curvatureAtStart), _curvatureRate((curvatureAtEnd - curvatureAtStart) / length)
{
    const double sharpest = std::max(std::fabs(curvatureAtStart), std::fabs(curvatureAtEnd));
    const double turnRad = std::min(sharpest * length, kMostTurnRad);
    const int panels = std::max(1, static_cast<int>(std::ceil(turnRad / kTurnOfPanelRad)));
    _spacing = length / panels;
    _points.reserve(static_cast<std::size_t>(panels));
    _points.emplace_back(0.0, 0.0);
    for (int i = 1; i < panels; ++i)
        _points.push_back(_points.back() + advance((i - 1) * _spacing, i * _spacing));
}

PlanPoint Clothoid::at(double s) const
{
    const double index = std::clamp(std::floor(s / _spacing), 0.0, static_cast<double>(_points.size() - 1));
    const glm::dvec2 start = _points[static_cast<std::size_t>(index)];
    return {start + advance(index * _spacing, s), headingAt(s), curvatureAt(s)};
}

glm::dvec2 Clothoid::advance(double from, double to) const
{
    const auto direction = [this](double s)
    {
        const double heading = headingAt(s);
        return glm::dvec2(std::cos(heading), std::sin(heading));
    };
    return integralOf(direction, from, to);
}

} // namespace osgRoads::core
