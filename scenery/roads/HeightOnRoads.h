// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>

namespace scenery
{

/// Returns the height on which something that comes from the height `fromM` stands at a point: of ground,
/// lanes and verges over each other the highest that is not more than kStepM above it, the lowest where all
/// are. A height that is not finite is not known: the highest road counts, also where it runs below the
/// ground. Surfaces closer than kLevelM to each other are one level, of which the one that is drawn counts: a
/// lane for cars before other lanes, as the mesh of a junction leaves those out, lanes before verge and
/// ground; of two alike the higher. Bridges and tunnels have no verge, tunnels a walkway; ground in a tunnel
/// does not count, as it is not drawn.
/// `ground`: the point on the ground. Frame: the scene's. Units: metres. Cost: some microseconds near roads.
/// Threads: any.
double heightOnRoads(const osgRoads::core::PlacedNetwork& roads, const glm::dvec3& ground, double fromM);

/// A wheel on a bank of 60° is 1.3 m above the middle of its car; a deck is 4 m above the road below it.
inline constexpr double kStepM = 1.5;
inline constexpr double kLevelM = 1.0;

} // namespace scenery
