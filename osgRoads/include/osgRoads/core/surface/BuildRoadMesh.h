// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/place/RoadBed.h>
#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// How finely the surface of a network is sampled. Units: metres.
struct RoadMeshSettings
{
    double chunkM = 64.0;       ///< greatest length of a chunk
    double errorM = 0.003;      ///< of the finest level, where it can be reached
    double shortestStepM = 0.2; ///< cross-sections are not closer than about this
    double junctionStepM = 2.0; ///< nor, where roads overlap, farther apart than this
    RoadBed bed;
};

/// Returns settings by which the surface of a network fits into memory: as above up to 300 km, coarser in
/// proportion beyond, by 1 cm at most.
RoadMeshSettings meshSettingsFor(const RoadNetwork& network);

/// Makes the drawn surface of a network: lanes, kerbs where lane heights step, verges and skirts, with what
/// is painted along the borders. Roads that cannot be used are left out, and what lies more than
/// RoadMesh::kReachM from the middle of the network.
/// Method: cross-sections of a chunk lie at s in equal steps, whose number doubles until the measured error
/// is small enough; each level leaves out every other one. A level's error is the greatest distance, over
/// cross-sections twice as dense as the finest level, of a point from the level's line between the
/// cross-sections beside it at the same place across; what it is off along that line counts a tenth, and the
/// outer edges of skirts, which lie in the ground, do not count.
/// Cost: about 1 µs of processor time a vertex; parts of 64 roads are made in as many threads as the machine
/// has, with the same result for any number of them.
RoadMesh buildRoadMesh(const PlacedNetwork& network, const RoadMeshSettings& settings = {});

/// Returns a line about the roads that are not in a mesh since they lie too far from the middle of their
/// network; empty when all are.
std::string unreachedMessage(const RoadMesh& mesh, const RoadNetwork& network, const std::string& file);

} // namespace osgRoads::core
