// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <foundation/Heights.h>
#include <glm/vec3.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>

namespace worldmaking
{

/// A railway as it is drawn: places of its formation; or the surface of a footbridge. Frame: the scene's.
struct RailLine
{
    std::vector<glm::dvec3> points;
    bool isTube = false, isFootbridge = false;
};

/// What is wrong where ways cross.
enum class CrossingFlaw : std::uint8_t
{
    roads,      ///< a road passes over another with too little room
    rails,      ///< a road and a railway likewise, neither on one level nor apart
    tunnel,     ///< the roof of a tunnel lies above the ground
    railEnd,    ///< rails end at a road, or in a step
    footbridge, ///< one passes over or under a road with too little room
    lines       ///< railways and footbridges pass over each other with too little room
};

/// The word that tables have for a fault.
const char* wordOf(CrossingFlaw flaw);

struct CrossingFault
{
    CrossingFlaw flaw = CrossingFlaw::roads;
    int road = -1; ///< the upper one of two; that of the tunnel; -1: a step of rails, a tunnel of a railway,
                   ///< lines
    int other = -1;
    double sM = 0.0; ///< along `road`
    double foundM =
        0.0; ///< the room that is clear; of a tunnel, how far its roof stands out; of rails, the step
    double wantedM = 0.0;
    bool isRoadAbove = true;                                   ///< of a railway
    bool isUpperFootbridge = false, isLowerFootbridge = false; ///< of lines; else a railway
    glm::dvec3 place{0.0};
};

/// Looks at all crossings of roads, railways and footbridges in the plan, at tunnels each 5 m, and at the
/// ends of rails.
/// `groundM`: at a place of the scene. Cost: some microseconds for each 4 m of road.
std::vector<CrossingFault> crossingFaults(const osgRoads::core::PlacedNetwork* roads,
                                          std::span<const RailLine> rails,
                                          const foundation::HeightInPlan& groundM);

inline constexpr double kLeastClearM = 4.3; ///< 4.5 m, less what rounding takes
inline constexpr double kSameLevelM = 0.35; ///< between what crosses at one level

} // namespace worldmaking
