// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/place/PlacedNetwork.h>

namespace osgRoads::core
{

/// Whether the ground beside the lanes of a junction is paved: the mesh of roads leaves no wedges of grass
/// between connecting roads.
/// Frame: the network's plan (inertial). Units: metres. Exact to a stretch of the mesh, which is paved or not
/// as a whole.
bool isPavedGap(const PlacedNetwork& network, const glm::dvec2& plan);

} // namespace osgRoads::core
