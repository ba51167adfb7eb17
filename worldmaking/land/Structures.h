// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include "worldmaking/land/Runways.h"
#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/streets/Footbridges.h"
#include "worldmaking/streets/Track.h"

namespace worldmaking
{

/// What became of what stands along lines.
struct StructureReport
{
    std::size_t walls = 0, fences = 0, powerLines = 0, railways = 0, turbines = 0, windsocks = 0;
    std::size_t footbridges = 0, streetLamps = 0, litStreets = 0, unlitStreets = 0;
    std::size_t cut = 0; ///< walls and fences that a road runs through
    std::size_t beyondGround = 0;
    std::size_t written = 0; ///< lines and points in the file
};

/// What keeps structures away.
struct StructureRoom
{
    const RoadRoom& roads;
    std::span<const Runway> runways;
    std::span<const PlanRings> strips; ///< of the runways
    foundation::HeightInPlan ground;
    /// railways with heights of their own, by their shapes in the map
    std::span<const Track> tracks{};
    std::span<const Footbridge> footbridges{}; ///< with their ramps
};

/// Writes walls, fences, power lines, railways, wind turbines, windsocks and street lamps of a map, and which
/// streets it says are lit or not, as a GeoPackage that `structures` of a .roam file reads. Railways and
/// footbridges with heights have them in the attribute `heights`, one for each point. Walls and fences end
/// kGateM before lanes; a runway without a windsock of the map gets one beside its strip. Nothing is written
/// where the map has none. Errors: as MapFile::finish().
foundation::Outcome writeStructures(const LandMap& map, const MapPlane& plane, const StructureRoom& room,
                                    const std::filesystem::path& file, StructureReport& report);

inline constexpr double kGateM = 0.7;

} // namespace worldmaking
