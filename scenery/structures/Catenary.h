// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace scenery
{

/// Returns points of a wire that hangs between two places: a catenary of constant `a` (metres: tension over
/// weight), both ends among them. `pieces`: of equal length in plan, 1 or more.
/// Source: y = a cosh(x / a); for level ends its sag is near L²/8a: 7.5 m at 300 m with a = 1500.
std::vector<glm::dvec3> catenary(const glm::dvec3& from, const glm::dvec3& to, double aM, int pieces);

inline constexpr double kLineConstantM = 1500.0, kPoleConstantM = 1200.0;

} // namespace scenery
