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

/// Cuts a loop without holes (see bridgeHoles()) into counter-clockwise triangles of its points. No triangle
/// has area zero; no other point lies in or on a triangle. The best-shaped ear is cut first. Returns nothing
/// if the loop's edges cross or it is not counter-clockwise.
/// Cost: for each triangle, three triangles are tested against the reflex points near them: n log n,
/// quadratic at worst.
/// Source: Jin, *Polygon Techniques*, "ear clipping"; Meisters, "Polygons have ears" (1975). O'Rourke,
/// "Computational geometry in C" (1998), §1.4: a cut changes only its neighbours, and only reflex points can
/// lie in an ear. Differs: loops may touch themselves; straight points count as reflex; exact.
std::optional<std::vector<Triangle>> clipEars(std::span<const glm::dvec2> points, const Loop& loop);

} // namespace osgPMObjects::core
