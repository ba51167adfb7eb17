// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// The order in which the faces of a mesh are kept; TriangleOrders.h describes each.
enum class FaceOrder
{
    asTheyAre,
    library,   ///< for plain caches: meshoptimizer's order
    universal, ///< for caches of any size
    locality,  ///< for a vertex cache that is a queue of 16 vertices
};

/// Orders the faces of each part and material (those that one call draws) by the vertices that they share.
/// Equal wedges (firstEqualWedges()) count as one vertex. Each list position keeps its part and material.
/// Cost: that of the order, plus a sort.
void orderFaces(Mesh& mesh, FaceOrder order);

/// Returns an order of triangles with vertices at positions, as hilbertOrder() does.
using TriangleOrder =
    std::function<std::vector<std::uint32_t>(std::span<const Triangle>, std::span<const glm::dvec3>)>;

/// Does so in any order.
void orderFaces(Mesh& mesh, const TriangleOrder& order);

} // namespace osgPMObjects::core
