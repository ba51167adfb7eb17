// SPDX-License-Identifier: Apache-2.0
#pragma once

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

} // namespace osgPMObjects::core
