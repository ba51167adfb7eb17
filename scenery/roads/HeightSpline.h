// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scenery
{

/// Returns the weights of four neighbouring coefficients in a uniform cubic B-spline at the share `u` of the
/// middle interval.
/// Source: Farin, *Curves and Surfaces for CAGD*, 2002, chapter 8.
inline std::array<double, 4> splineWeights(double u)
{
    const double v = 1.0 - u;
    return {v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
            (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0, u * u * u / 6.0};
}

/// A height over the distance along a line: a uniform cubic B-spline. It is never steeper than the steepest
/// line between neighbouring coefficients, and its curvature is continuous. Beyond its ends it goes on
/// straight.
/// Units: metres.
struct HeightSpline
{
    double stepM = 1.0;
    std::vector<double>
        heightsM; ///< the coefficients at -stepM, 0, stepM, … and one beyond the end; four or more

    double lengthM() const { return stepM * static_cast<double>(heightsM.size() - 3); }

    double heightM(double alongM) const
    {
        const double withinM = std::clamp(alongM, 0.0, lengthM());
        const auto [first, u] = intervalAt(withinM);
        const auto weights = splineWeights(u);
        double sum = 0.0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += weights[i] * heightsM[first + i];
        return alongM == withinM ? sum : sum + (alongM - withinM) * grade(withinM);
    }

    /// Returns the rise in metres per metre.
    double grade(double alongM) const
    {
        const auto [first, u] = intervalAt(std::clamp(alongM, 0.0, lengthM()));
        const double v = 1.0 - u;
        const std::array<double, 3> weights = {0.5 * v * v, 0.5 + u * v, 0.5 * u * u};
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += weights[i] * (heightsM[first + i + 1] - heightsM[first + i]);
        return sum / stepM;
    }

private:
    struct Interval
    {
        std::size_t first; ///< of the coefficients that count
        double u;
    };
    Interval intervalAt(double alongM) const
    {
        const double place = alongM / stepM;
        const double first = std::min(std::floor(place), static_cast<double>(heightsM.size() - 4));
        return {static_cast<std::size_t>(first), place - first};
    }
};

} // namespace scenery
