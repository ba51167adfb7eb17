// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace scenery::models
{

/// A smooth curve through given points without overshoot: it is monotonic between two points.
/// Source: Fritsch & Carlson, *Monotone Piecewise Cubic Interpolation*, 1980, with the harmonic mean of
/// Fritsch & Butland, 1984, for the slopes. Invariant: at least two points, abscissae increasing.
class Curve
{
public:
    struct Point
    {
        double at, value;
    };
    explicit Curve(std::vector<Point> points);

    /// 0 everywhere.
    Curve() : Curve({{0.0, 0.0}, {1.0, 0.0}}) {}

    /// Evaluates the curve. Outside the points the value is that of the nearest end.
    double operator()(double at) const;
    const std::vector<Point>& points() const { return _points; }

private:
    std::vector<Point> _points;
    std::vector<double> _slopes;
};

} // namespace scenery::models
