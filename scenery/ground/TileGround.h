// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/tour/LayTour.h"

namespace ground
{

/// A terrain tile as the simulation sees it. `tile` must outlive what is made from it.
/// Frame: the tile's local east-north-up, which is the scene's.

/// The frame's origin; absent for a planar tile.
std::optional<simulation::Geodetic> originOf(const osgTerrainROAM::core::PlacedTile& tile);

/// The true surface.
simulation::GroundProvider groundOf(const osgTerrainROAM::core::PlacedTile& tile);

/// What a tour is laid over: the largest rectangle of the frame that lies within the data. A strip that is
/// too narrow to hold one has the mean extent of its sides.
simulation::TourTerrain tourTerrainOf(const osgTerrainROAM::core::PlacedTile& tile,
                                      const std::string& sceneFile);

} // namespace ground
