// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/CubicSpline.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace simulation
{

CubicSpline::CubicSpline(std::vector<double> knots, std::vector<double> values, Kind kind)
    : _knots(std::move(knots)), _values(std::move(values)), _second(_knots.size(), 0.0)
{
    assert(_knots.size() >= 2 && _knots.size() == _values.size());
    if (kind == Kind::natural) solveSecondDerivatives();
}

/// The tridiagonal system of the natural spline, by elimination (Thomas).
void CubicSpline::solveSecondDerivatives()
{
    const std::size_t last = _knots.size() - 1;
    std::vector<double> upper(_knots.size(), 0.0);
    for (std::size_t i = 1; i < last; ++i)
    {
        const double before = _knots[i] - _knots[i - 1];
        const double after = _knots[i + 1] - _knots[i];
        const double slopeChange =
            (_values[i + 1] - _values[i]) / after - (_values[i] - _values[i - 1]) / before;
        const double pivot = 2.0 * (before + after) - before * upper[i - 1];
        upper[i] = after / pivot;
        _second[i] = (6.0 * slopeChange - before * _second[i - 1]) / pivot;
    }
    for (std::size_t i = last; i-- > 1;)
        _second[i] -= upper[i] * _second[i + 1];
}

std::size_t CubicSpline::interval(double parameter) const
{
    const auto above = std::upper_bound(_knots.begin(), _knots.end(), parameter);
    const std::ptrdiff_t index = above - _knots.begin() - 1;
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(_knots.size()) - 2));
}

CubicSpline::Sample CubicSpline::at(double parameter) const
{
    const std::size_t i = interval(parameter);
    const double width = _knots[i + 1] - _knots[i];
    const double u = std::clamp(parameter, begin(), end());
    // Exact at both knots: the weights are exactly 0 and 1 there.
    const double b = (u - _knots[i]) / width;
    const double a = (_knots[i + 1] - u) / width;
    const double scale = width * width / 6.0;
    Sample sample;
    sample.value = a * _values[i] + b * _values[i + 1] +
                   ((a * a * a - a) * _second[i] + (b * b * b - b) * _second[i + 1]) * scale;
    sample.first = (_values[i + 1] - _values[i]) / width +
                   ((3.0 * b * b - 1.0) * _second[i + 1] - (3.0 * a * a - 1.0) * _second[i]) * width / 6.0;
    sample.second = a * _second[i] + b * _second[i + 1];
    return sample;
}

} // namespace simulation
