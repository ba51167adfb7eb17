// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include <foundation/Result.h>

#include <osgRoads/core/network/RoadNetwork.h>

#include "worldmaking/land/Runways.h"
#include "worldmaking/madeup/MadeUpMap.h"
#include "worldmaking/map/MapPlane.h"

namespace worldtool
{

/// What the rides of a made-up world are made of.
struct RideSource
{
    const osgRoads::core::RoadNetwork& network;
    const worldmaking::MapPlane& plane;
    std::span<const worldmaking::MadeUpPlace> places;
    std::span<const worldmaking::Runway> runways;
    std::function<glm::dvec3(const glm::dvec2& degrees)>
        placeInScene; ///< where the ground is in the scene that shows the world
};

/// Writes scenarios of a made-up world (OpenSCENARIO): drive.xosc, a car that a driver drives into the town
/// or else along the longest road, with traffic on the roads around it and an aircraft in the circuit of the
/// airfield; circuit.xosc, the same seen from the aircraft. The second only where there is a runway; none
/// without roads. Errors: files that cannot be written.
foundation::Outcome writeRides(const RideSource& source, const std::filesystem::path& world);

} // namespace worldtool
