// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/query/LaneRoute.h>

namespace osgRoads::core
{

/// Chooses a drive to see a network by: `lengthM` long where the network allows it, through up to three
/// junctions, in the outermost driving lane; straight on at each junction, sideways only where a lane ends. A
/// drive that no lane is left for ends there.
/// A route without legs: the network has no lane for cars.
/// Cost: some microseconds a lane. Deterministic: of equal drives the first counts.
LaneRoute chooseDrive(const RoadNetwork& network, const LaneGraph& graph, double lengthM);

} // namespace osgRoads::core
