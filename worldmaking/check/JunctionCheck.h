// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>

namespace worldmaking
{

/// What is wrong with the surface of a junction.
enum class JunctionFlaw : std::uint8_t
{
    step,  ///< two lanes for cars lie over each other, one higher than the other
    steep, ///< it leans more than streets climb
};

/// The worst place of a connecting road.
struct JunctionFault
{
    JunctionFlaw flaw = JunctionFlaw::step;
    int road = -1;             ///< of a junction
    int other = -1;            ///< that lies over it or below; -1: none
    double sM = 0.0, by = 0.0; ///< along the road; metres between both, or rise for each metre in the plan
    glm::dvec3 place{0.0};     ///< in the scene
};

/// Looks at all connecting roads that lie on the ground, each metre along at both edges and in the middle:
/// where their lanes for cars and those of other roads lie over each other, none is higher than the other by
/// kMostJunctionStepM; the surface leans by kMostJunctionLean at most, in any direction. Roads that are
/// farther than kOtherLevelM apart pass over each other.
/// Cost: some microseconds for each metre.
std::vector<JunctionFault> junctionFaults(const osgRoads::core::PlacedNetwork& roads);

inline constexpr double kMostJunctionStepM = 0.05, kOtherLevelM = 2.0, kMostJunctionLean = 0.2;

} // namespace worldmaking
