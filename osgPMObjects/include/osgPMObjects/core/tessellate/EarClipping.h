// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/tessellate/InsideLoops.h>

namespace osgPMObjects::core
{

/// Cuts a loop without holes, as bridgeHoles() leaves it, into counter-clockwise triangles of its points, none of area zero;
/// no other point lies in or on a triangle. The best-shaped ear goes first.
/// Errors: nothing, when the loop is not one: its edges cross, or it is not counter-clockwise.
/// Cost: a test of three triangles against the reflex points near them for each triangle: n log n, quadratic at worst.
/// Source: paper 002, "ear clipping"; Meisters, "Polygons have ears" (1975). That only the neighbours of what was cut change,
/// and only points that are not convex can lie in an ear: O'Rourke, "Computational geometry in C" (1998), §1.4. Differs:
/// loops may touch themselves; straight points count as reflex; exact.
std::optional<std::vector<Triangle>> clipEars(std::span<const glm::dvec2> points, const Loop& loop);

} // namespace osgPMObjects::core
