// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/place/PlacedNetwork.h>

namespace trainer
{

/// A network as it lies in the frame of a scene: each road turned and moved as a whole, its heights tilted with it, so that scenarios can
/// place entities on lanes of a georeferenced world. A road of 1.5 km leaves the placed one by 5 cm at most (the Earth's curve, and
/// a scale that grows with height); entities stand on the scene's own ground. Frame: the scene's, no georeference.
osgRoads::core::RoadNetwork roadsInScene(const osgRoads::core::PlacedNetwork& roads);

} // namespace trainer
