// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/vehicles/Curve.h"

#include <algorithm>
#include <cassert>

#include <glm/common.hpp>

namespace scenery::models
{

Curve::Curve(std::vector<Point> points) : _points(std::move(points)), _slopes(_points.size(), 0.0)
{
    assert(_points.size() >= 2);
    const auto secant = [&](std::size_t i)
    { return (_points[i + 1].value - _points[i].value) / (_points[i + 1].at - _points[i].at); };
    _slopes.front() = secant(0);
    _slopes.back() = secant(_points.size() - 2);
    for (std::size_t i = 1; i + 1 < _points.size(); ++i)
    {
        const double before = secant(i - 1);
        const double after = secant(i);
        _slopes[i] = before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
    }
}

double Curve::operator()(double at) const
{
    if (at <= _points.front().at) return _points.front().value;
    if (at >= _points.back().at) return _points.back().value;
    const auto above = std::upper_bound(_points.begin(), _points.end(), at,
                                        [](double x, const Point& p) { return x < p.at; });
    const auto i = static_cast<std::size_t>(above - _points.begin()) - 1;
    const Point& a = _points[i];
    const Point& b = _points[i + 1];
    const double h = b.at - a.at;
    const double t = (at - a.at) / h;
    const double s = 1.0 - t;
    return s * s * (1.0 + 2.0 * t) * a.value + glm::smoothstep(0.0, 1.0, t) * b.value +
           h * t * s * (s * _slopes[i] - t * _slopes[i + 1]);
}

} // namespace scenery::models
