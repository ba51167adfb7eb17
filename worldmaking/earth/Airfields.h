// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <foundation/Heights.h>

#include <osgTerrainROAM/core/edit/Earthworks.h>

#include "worldmaking/land/Runways.h"
#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

/// What became of airfields.
struct AirfieldReport
{
    std::size_t runways = 0;      ///< on the ground
    std::size_t steepRunways = 0; ///< steeper than their length allows, as the ground is
    std::size_t taxiways = 0, aprons = 0;
    std::size_t beyondGround = 0;
};

/// Returns the runways of a map (aeroway=runway, lines and long areas) and those of a table that the map does
/// not have. A runway of both has the map's place and what the map leaves out from the table.
std::vector<Runway> runwaysOf(const LandMap& map, const MapPlane& plane, std::span<const Runway> table);

/// Levels the aprons, taxiways and runways of a map: smooth profiles along, runways crowned across, graded
/// strips beside and beyond, slopes of one in three to the ground. Aprons follow the ground that runways have
/// shaped; taxiways join both.
/// Frame: the plane. Sources: those of RunwayProfile.h.
std::vector<osgTerrainROAM::core::Earthwork>
airfieldWorks(const LandMap& map, std::span<const Runway> runways, const MapPlane& plane,
              const foundation::HeightInPlan& ground, AirfieldReport& report);

} // namespace worldmaking
