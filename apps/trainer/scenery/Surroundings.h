// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace trainer::scenery
{

/// What objects stand on. Functions must give the same answer for the same place always.
/// Frame: the scene's east-north-up. Units: metres.
struct Ground
{
    std::function<std::optional<double>(double eastM, double northM)> heightM; ///< nothing beyond the data
    std::function<std::string_view(double eastM, double northM)> cover;        ///< its name; empty: not known
    double seaLevelM = -std::numeric_limits<double>::infinity();
};

/// A line with everything within `halfWidthM` of it.
struct Corridor
{
    std::vector<glm::dvec2> line; ///< at least one place: a disc
    double halfWidthM = 0.0;
};

/// Where nothing may stand, and where the scenario happens.
struct Ways
{
    std::vector<Corridor> keepClear;
    std::vector<std::vector<glm::dvec2>> paths; ///< of entities, airborne ones too
};

} // namespace trainer::scenery
