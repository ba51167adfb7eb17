// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "simulation/vehicle/Ground.h"

namespace trainer
{

/// What a `<material surface>` of OpenDRIVE means to tyres. Nothing: no word that is known; the format leaves
/// them to its user.
std::optional<simulation::GroundKind> groundKindOf(std::string_view surface);

/// Whether a lane of the network says what it is made of.
bool hasMaterials(const osgRoads::core::RoadNetwork& network);

/// What the lane below a point is made of; nothing: there is no lane, or it does not say. Frame: that of the
/// network's place.
std::optional<simulation::GroundKind> laneMaterialAt(const osgRoads::core::PlacedNetwork& roads,
                                                     const glm::dvec3& point);

} // namespace trainer
