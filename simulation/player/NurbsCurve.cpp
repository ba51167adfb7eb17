// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/NurbsCurve.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace simulation
{
namespace
{

double quotient(double dividend, double divisor)
{
    return divisor > 0.0 ? dividend / divisor : 0.0;
}

/// The last interval that is not empty and begins by a parameter, of those that the curve is made of.
std::size_t spanOf(const std::vector<double>& knots, std::size_t points, std::size_t degree, double parameter)
{
    std::size_t span = degree;
    for (std::size_t i = degree; i < points; ++i)
        if (knots[i] <= parameter && knots[i] < knots[i + 1]) span = i;
    return span;
}

} // namespace

NurbsCurve::NurbsCurve(std::vector<glm::dvec4> points, std::vector<double> knots, int degree)
    : _points(std::move(points)), _knots(std::move(knots)), _degree(degree)
{
    const auto p = static_cast<std::size_t>(degree);
    assert(degree >= 1 && _points.size() > p && _knots.size() == _points.size() + p + 1);
    for (std::size_t i = 0; i + 1 < _points.size(); ++i)
        _hodograph.push_back((_points[i + 1] - _points[i]) *
                             quotient(static_cast<double>(degree), _knots[i + p + 1] - _knots[i + 1]));
    _innerKnots.assign(_knots.begin() + 1, _knots.end() - 1);
}

glm::dvec4 NurbsCurve::value(const std::vector<glm::dvec4>& points, const std::vector<double>& knots,
                             int degree, double parameter)
{
    const auto p = static_cast<std::size_t>(degree);
    const std::size_t span = spanOf(knots, points.size(), p, parameter);
    std::vector<glm::dvec4> corner(points.begin() + static_cast<std::ptrdiff_t>(span - p),
                                   points.begin() + static_cast<std::ptrdiff_t>(span + 1));
    for (std::size_t round = 1; round <= p; ++round)
        for (std::size_t i = p; i >= round; --i)
        {
            const double left = knots[span - p + i];
            const double share = quotient(parameter - left, knots[span + 1 + i - round] - left);
            corner[i] = corner[i - 1] * (1.0 - share) + corner[i] * share;
        }
    return corner[p];
}

glm::dvec3 NurbsCurve::at(double parameter) const
{
    const glm::dvec4 point = value(_points, _knots, _degree, std::clamp(parameter, begin(), end()));
    return glm::dvec3(point) / point.w;
}

glm::dvec3 NurbsCurve::tangentAt(double parameter) const
{
    const double u = std::clamp(parameter, begin(), end());
    const glm::dvec4 point = value(_points, _knots, _degree, u);
    const glm::dvec4 slope = value(_hodograph, _innerKnots, _degree - 1, u);
    return (glm::dvec3(slope) * point.w - glm::dvec3(point) * slope.w) / (point.w * point.w);
}

double NurbsCurve::basis(std::size_t point, double parameter) const
{
    std::vector<glm::dvec4> only(_points.size(), glm::dvec4(0.0));
    only[point].x = 1.0;
    return value(only, _knots, _degree, std::clamp(parameter, begin(), end())).x;
}

} // namespace simulation
