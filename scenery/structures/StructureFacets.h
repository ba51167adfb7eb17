// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include <foundation/Heights.h>

#include "scenery/buildings/BuildingFacets.h"
#include "scenery/structures/Structure.h"

namespace scenery
{

/// The triangles of the structures in one square of the plan, in a frame about one of its places.
struct StructureSquare
{
    glm::dvec3 origin{0.0};
    Facets fine;   ///< lattices, sleepers, wires: drawn up to kStructureFineM
    Facets coarse; ///< what stands for them farther away, up to kStructureCoarseM
    Facets low;    ///< walls, fences, rails: drawn up to kStructureLowM
};

/// Squares by their number to the east and north.
using StructureSquares = std::map<std::pair<std::int64_t, std::int64_t>, StructureSquare>;

/// Builds structures on the ground: walls and fences that follow it, pylons with their wires, rails on their
/// sleepers, wind turbines. Those of which a place has no ground are left out, and counted in `beyondGround`.
/// Frame: the scene's. Cost: some 20 µs a metre of wall, 200 µs a pylon.
StructureSquares structureFacets(std::span<const Structure> structures,
                                 const foundation::HeightInPlan& ground, std::size_t& beyondGround);

inline constexpr double kStructureSquareM = 250.0;
inline constexpr double kStructureFineM = 700.0, kStructureCoarseM = 7000.0, kStructureLowM = 1200.0;

} // namespace scenery
