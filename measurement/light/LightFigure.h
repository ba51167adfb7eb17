// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace measurement
{

/// One measured figure of light, air or sky, and the limits that it has to keep.
struct LightFigure
{
    std::string goal; ///< the goal that it belongs to, "N1" … "N10": docs/measurements/light.md has them all
    std::string name;
    double value = 0.0;
    std::string unit;
    double least = -std::numeric_limits<double>::infinity(); ///< in the unit of the value
    double most = std::numeric_limits<double>::infinity();
    std::string source; ///< of the limits, and of what was compared with

    /// A figure that is no number does not pass.
    bool passes() const { return value >= least && value <= most; }
};

using LightFigures = std::vector<LightFigure>;

inline constexpr double kPercent = 100.0;

/// Returns a figure that may be as large as `most`.
inline LightFigure atMost(const char* goal, std::string name, double value, const char* unit, double most,
                          const char* source)
{
    LightFigure figure;
    figure.goal = goal;
    figure.name = std::move(name);
    figure.value = value;
    figure.unit = unit;
    figure.most = most;
    figure.source = source;
    return figure;
}

} // namespace measurement
