// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Heights.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "scenery/buildings/Building.h"
#include "worldmaking/check/CrossingCheck.h"
#include "worldmaking/check/JunctionCheck.h"
#include "worldmaking/check/LevelCheck.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Everything of a world that can stand wrong. Frame: the scene's. Units: metres.
struct WorldThings
{
    const osgRoads::core::PlacedNetwork* roads = nullptr; ///< null: none
    std::vector<scenery::StandingBuilding> houses;
    std::vector<glm::dvec2> plants; ///< trees, and whatever else stands at a point
    std::vector<RailLine> rails;
    std::vector<PlanRings> waters, runways;
    PlanRings courses;                ///< lines of rivers and streams, downstream
    foundation::HeightInPlan groundM; ///< with its cuttings; nothing beyond the data
    foundation::HeightInPlan
        elevationM; ///< the same in the datum of the samples; empty: runways and waters are not measured
};

/// The worst place of a road that the ground leaves or covers.
struct RoadFault
{
    bool isSunk = false; ///< covered; otherwise floating
    int road = -1;
    double sM = 0.0, byM = 0.0; ///< along the road; from the road down to the ground, or up to it
    glm::dvec3 place{0.0};      ///< on the road
    int other = -1;             ///< the nearest other road that may be the reason; -1: none within kReasonM
    double otherM = 0.0;        ///< from the place to its lanes
    double otherHigherM = 0.0;  ///< by which it lies higher, or lower
    static constexpr double kReasonM = 20.0, kReasonHeightM = 0.3;
};

/// A house that does not stand on its ground.
struct HouseFault
{
    enum class Flaw
    {
        floats, ///< its walls end above the ground
        sunk,   ///< less than kLeastShownM of its walls stand above its lowest ground
        beyond, ///< there is no ground below some of it
    };
    Flaw flaw = Flaw::floats;
    glm::dvec3 place{0.0}; ///< the middle of the rectangle around it, at its floor, in the scene
    double byM = 0.0;      ///< from the lowest ground up to the foot of its walls, or to its eaves
    static constexpr double kLeastShownM = 2.0; ///< or as much as there is
};

/// Open water that does not lie as water does.
struct WaterFault
{
    glm::dvec2 place{0.0}; ///< the middle of the box around it, in the scene
    double areaM2 = 0.0;
    LevelFigures figures;
    std::string name{}; ///< of the map; empty: none, or not known here
};

/// What stands wrong, and how much there is.
struct WorldFaults
{
    std::size_t objects = 0;     ///< houses and plants
    double roadsKm = 0.0;        ///< without crossings
    std::size_t onRoad = 0;      ///< objects on lanes, tunnels left out
    std::size_t inWater = 0;     ///< houses whose middle, plants whose foot is in water
    std::size_t onRunway = 0;    ///< objects on the paving of a runway
    std::size_t overlapping = 0; ///< pairs of houses with common ground, and plants within houses
    std::size_t floating = 0;    ///< houses that do not stand on their ground (HouseFault), trees without any
    std::size_t floatingRoads = 0,
                sunkRoads = 0; ///< roads that the ground leaves, or covers, somewhere off bridges and tunnels
    std::size_t unevenRunways = 0;    ///< steep or bumpy (LevelCheck.h)
    std::size_t unevenWaters = 0;     ///< steep, or higher than their shores
    std::size_t closeCrossings = 0;   ///< roads and railways that cross with too little room
    std::size_t bareTunnels = 0;      ///< whose roof stands above the ground
    std::size_t brokenRails = 0;      ///< that end at a road, or in a step
    std::size_t steppedJunctions = 0; ///< connecting roads with another a step higher or lower
    std::size_t steepJunctions = 0;   ///< connecting roads that lean too much
    double maxGradePercent = 0.0;
    std::vector<RoadFault> roadFaults;   ///< one for each floating or sunk road, in their order
    std::vector<HouseFault> houseFaults; ///< one for each house that is counted as floating
    std::vector<WaterFault> waterFaults; ///< one for each uneven water
    std::vector<CrossingFault> crossingFaults;
    std::vector<JunctionFault> junctionFaults;

    /// Uneven junctions are told and not counted: no remedy in the map is known for most of them.
    std::size_t total() const
    {
        return onRoad + inWater + onRunway + overlapping + floating + floatingRoads + sunkRoads +
               unevenRunways + unevenWaters + closeCrossings + bareTunnels + brokenRails;
    }
};

/// Looks at everything by brute force: lanes each metre at both edges and in the middle, outlines each metre,
/// roads each 5 m. It shares no rule with what places things but the look-up of roads. Cost: some 2 µs a
/// metre of road and of outline, 3 µs a plant.
WorldFaults checkWorld(const WorldThings& things);

inline constexpr double kMostGapM =
    1.5; ///< between a road and the ground below its middle: its bed is 0.5 m deep
inline constexpr double kMostCoverM = 0.1; ///< of ground over a road

} // namespace worldmaking
