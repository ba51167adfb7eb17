// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace scenery::models
{

/// A smooth line through given points that never overshoots them: between two points it rises or falls only.
/// Source: Fritsch and Carlson, "Monotone piecewise cubic interpolation" (1980), with the harmonic mean of Fritsch and Butland
/// (1984) for the slopes. Invariant: two points or more, abscissae rising.
class Curve
{
public:
    struct Point
    {
        double at, value;
    };
    explicit Curve(std::vector<Point> points);

    /// Beyond its ends: the value there.
    double operator()(double at) const;
    const std::vector<Point>& points() const { return _points; }

private:
    std::vector<Point> _points;
    std::vector<double> _slopes;
};

} // namespace scenery::models
