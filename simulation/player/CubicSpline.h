// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace simulation
{

/// A function of one parameter that passes through given knots exactly.
/// `natural`: twice continuously differentiable, no curvature at the ends. `linear`: straight between the
/// knots.
/// Invariant: at least two knots, strictly increasing, and one value for each. Cost: construction linear,
/// evaluation logarithmic.
/// Source: de Boor, *A Practical Guide to Splines*, 1978, chapter IV (natural end conditions), written in
/// second derivatives.
class CubicSpline
{
public:
    enum class Kind
    {
        linear,
        natural,
    };

    struct Sample
    {
        double value = 0.0;
        double first = 0.0;  ///< derivative by the parameter
        double second = 0.0; ///< its derivative
    };

    CubicSpline() = default;
    CubicSpline(std::vector<double> knots, std::vector<double> values, Kind kind);

    /// Evaluates the spline. Outside the knots the value is that of the nearest end.
    Sample at(double parameter) const;

    double begin() const { return _knots.front(); }
    double end() const { return _knots.back(); }
    const std::vector<double>& knots() const { return _knots; }

    /// Returns the index of the interval that contains a parameter, 0 … knots - 2.
    std::size_t interval(double parameter) const;

private:
    void solveSecondDerivatives();

    std::vector<double> _knots;
    std::vector<double> _values;
    std::vector<double> _second; ///< second derivatives at the knots
};

} // namespace simulation
