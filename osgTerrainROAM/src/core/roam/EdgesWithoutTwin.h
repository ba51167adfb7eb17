// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// A directed edge between vertex slots.
using SlotEdge = std::pair<std::uint32_t, std::uint32_t>;

/// Gives each point the index of the first that lies at its place. Cost: one look into a hash table for each.
std::vector<std::uint32_t> firstAtPlace(std::span<const GridPoint> points);

/// Finds the edges of triangles that no triangle has in the opposite sense. `same`: by vertex slot, the slot
/// of the vertex that it counts as.
/// Cost: two visits of each edge.
std::vector<SlotEdge> edgesWithoutTwin(std::span<const LeafTriangle> triangles,
                                       std::span<const std::uint32_t> same);

} // namespace osgTerrainROAM::core
