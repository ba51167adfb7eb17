// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <foundation/Heights.h>
#include <glm/vec2.hpp>

namespace scenery
{

/// The ground below the objects. The same point must always give the same answer.
/// Frame: the scene's east-north-up. Units: metres.
struct Ground
{
    foundation::HeightInPlan heightM; ///< nothing beyond the data
    /// Returns the elevation above sea level of a point on the ground, which rules of height and water test.
    /// Empty: the height itself.
    std::function<double(double eastM, double northM, double heightM)> elevationM;
    std::function<std::string_view(double eastM, double northM)> cover; ///< its name; empty: not known
    double seaLevelM = -std::numeric_limits<double>::infinity();        ///< an elevation

    double elevationOf(double eastM, double northM, double height) const
    {
        return elevationM ? elevationM(eastM, northM, height) : height;
    }
};

/// A strip: all points within `halfWidthM` of a line.
struct Corridor
{
    std::vector<glm::dvec2> line; ///< at least one point; one point: a disc
    double halfWidthM = 0.0;
};

/// The strips to keep free, and the paths of the scenario.
struct Ways
{
    std::vector<Corridor> keepClear;
    std::vector<std::vector<glm::dvec2>> paths; ///< of entities, airborne ones too
};

} // namespace scenery
