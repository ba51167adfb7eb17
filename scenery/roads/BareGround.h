// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/place/PlacedNetwork.h>

namespace scenery
{

/// Whether roads keep the ground bare of plants at a place of the scene: on lanes, on the gravel 0.6 m beside
/// them, and where a junction is paved between its lanes.
bool isBareByRoads(const osgRoads::core::PlacedNetwork& roads, const glm::dvec3& place);

} // namespace scenery
