// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace scenery
{

/// What objects stand on. Functions must give the same answer for the same place always.
/// Frame: the scene's east-north-up. Units: metres.
struct Ground
{
    std::function<std::optional<double>(double eastM, double northM)> heightM; ///< nothing beyond the data
    /// Of a place on the ground, as maps count heights: what rules of height and water go by. Empty: the height itself.
    std::function<double(double eastM, double northM, double heightM)> elevationM;
    std::function<std::string_view(double eastM, double northM)> cover; ///< its name; empty: not known
    double seaLevelM = -std::numeric_limits<double>::infinity();        ///< an elevation

    double elevationOf(double eastM, double northM, double height) const
    {
        return elevationM ? elevationM(eastM, northM, height) : height;
    }
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

} // namespace scenery
