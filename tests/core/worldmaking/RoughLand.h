// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

/// Places and ground of made maps at 0 N 0 E.
namespace roughland
{

inline constexpr double kDegree = 111320.0; ///< metres, near enough there

inline std::vector<glm::dvec2> inDegrees(std::vector<glm::dvec2> metres)
{
    for (glm::dvec2& place : metres)
        place /= kDegree;
    return metres;
}

/// Ground that falls to the east, with humps of 1.5 m.
inline std::optional<double> falling(const glm::dvec2& place)
{
    return 300.0 - 0.03 * place.x + 1.5 * std::sin(0.05 * place.x) * std::cos(0.04 * place.y);
}

/// Ground that rises to the north-east, with waves of 2 m.
inline std::optional<double> waving(const glm::dvec2& place)
{
    return 200.0 + 0.012 * place.x + 0.03 * place.y + 2.0 * std::sin(0.02 * place.x);
}

} // namespace roughland
