// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// In which order the faces of a mesh are kept (TriangleOrders.h).
enum class FaceOrder
{
    asTheyAre,
    library,   ///< for plain caches: meshoptimizer's
    universal, ///< for caches of any size
    locality,  ///< for a queue of 16 vertices
};

/// Puts the faces of each part and material in order, by the wedges that they share (equal ones, firstEqualWedges(), are one vertex): the faces that one call draws. Which places in
/// the list belong to which part and material stays.
/// Cost: that of the order, plus a sort.
void orderFaces(Mesh& mesh, FaceOrder order);

} // namespace osgPMObjects::core
