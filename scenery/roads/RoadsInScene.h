// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/place/PlacedNetwork.h>

namespace scenery
{

/// A network as it lies in the frame of a scene, so that scenarios can place entities on lanes of a
/// georeferenced world: each element of a plan is put where both of its ends lie, and heights are raised by
/// what the placed road differs from them, measured each 250 m.
/// Error: 2 mm in height (what the Earth curves away from a chord of 250 m); along an element of L metres
/// that lies h metres high L h / 6.4e6, as the scene is so much wider there. Frame: the scene's, no
/// georeference.
osgRoads::core::RoadNetwork roadsInScene(const osgRoads::core::PlacedNetwork& roads);

} // namespace scenery
