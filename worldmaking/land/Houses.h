// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scenery/buildings/Building.h"
#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// A building or tower of a map that stands right. `rings` of the building: in the plane.
struct House
{
    LandShape shape; ///< as the map has it, its outline perhaps cut back (degrees)
    scenery::Building building;
    std::int64_t whole = 0; ///< the id of the building that it is a part of; 0: it is none
};

/// What became of a map's buildings.
struct HouseReport
{
    std::size_t read = 0, underground = 0, unusable = 0, beyondGround = 0;
    std::size_t cutBack = 0;     ///< their outline reached onto a road
    std::size_t onRoad = 0;      ///< left out: too little of them lies beside the roads
    std::size_t overlapping = 0; ///< left out: they lie over a larger one
    std::size_t onRunway = 0;    ///< left out: they reach onto a runway's strip
    std::size_t inWater = 0;     ///< left out: their middle lies in water
    std::size_t passages = 0;    ///< houses that a street runs through
    std::size_t parts = 0;       ///< of buildings (building:part)
    std::size_t standing = 0, towers = 0;
};

/// Tells whether a place of the plane has ground.
using HasGround = std::function<bool(const glm::dvec2& plan)>;

/// What houses must leave free. Frame: the plane.
struct HouseRoom
{
    const RoadRoom& roads;
    std::span<const PlanRings> strips; ///< of runways
    HasGround hasGround;
};

/// Takes the buildings and their parts (keys `building`, `building:part`: HouseParts.h) and towers of a map
/// that can stand: none within kHouseRoomM of a lane, none on a runway, none over another but of one
/// building, none in water. Larger ones come first where two overlap. A house with a passage (Passages.h)
/// becomes the parts beside the street, and one over it from kPassageM up; they are parts of one building.
/// Sources: as scenery::buildingOf().
std::vector<House> housesOf(const LandMap& map, const MapPlane& plane, const HouseRoom& room,
                            HouseReport& report);

inline constexpr double kHouseRoomM = 0.5;    ///< between a house and lanes
inline constexpr double kMostOverlapM2 = 1.0; ///< of two houses, or …
inline constexpr double kMostOverlap = 0.03;  ///< … this share of the smaller

/// The common area of two outlines, square metres. Source: GEOS, through OGR.
double commonAreaOf(const PlanRings& a, const PlanRings& b);

} // namespace worldmaking
