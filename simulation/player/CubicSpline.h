// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace simulation
{

/// A value as a function of one parameter through given knots, exact at every knot.
/// `natural`: twice continuously differentiable, no curvature at the ends. `linear`: straight between the knots.
/// Invariant: knots rise strictly; as many values as knots, two at least.
/// Cost: construction linear; evaluation logarithmic.
/// Source: de Boor, A Practical Guide to Splines, chapter IV (natural end conditions), in terms of second derivatives.
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

    /// Beyond the ends the end's value.
    Sample at(double parameter) const;

    double begin() const { return _knots.front(); }
    double end() const { return _knots.back(); }
    const std::vector<double>& knots() const { return _knots; }

    /// Index of the interval that holds a parameter, 0 … knots - 2.
    std::size_t interval(double parameter) const;

private:
    void solveSecondDerivatives();

    std::vector<double> _knots;
    std::vector<double> _values;
    std::vector<double> _second; ///< second derivatives at the knots
};

} // namespace simulation
