// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/lights/LightPoint.h"

namespace scenery
{

/// A street in the plan. Frame: the scene's.
struct StreetLine
{
    std::vector<glm::dvec2> middle;
    double widthM = 6.0;
};

/// A street lamp: its post in the plan, the unit vector to its street, and the height of its light.
struct StreetLamp
{
    glm::dvec2 place{0.0}, towards{1.0, 0.0};
    double heightM = 6.0;
    bool isSodium = false; ///< orange, else warm white
};

/// What a map tells of street lamps. Frame: the scene's.
struct MappedLamps
{
    std::vector<glm::dvec2> posts;                   ///< lamps
    std::vector<std::vector<glm::dvec2>> lit, unlit; ///< lines of streets that are lit, or are not
};

/// Returns the lamps of streets: every 32 m, by turns on both sides, on no street, where the map says that a
/// street is lit, and where it says nothing and two houses or more stand within 60 m. Lamps that the map has
/// stand in their places, towards the nearest street, and none is added within 48 m of one. Wide streets have
/// higher lamps, sodium is left in a third of the streets.
/// `houses`: their middles. Deterministic. Cost: linear.
/// Source: EN 13201-2 asks for classes P4 to P6 there; posts of 5 to 6 m stand 25 to 35 m apart.
std::vector<StreetLamp> streetLampsAlong(std::span<const StreetLine> streets,
                                         std::span<const glm::dvec2> houses, const MappedLamps& mapped = {});

/// Returns the light of a lamp whose post stands on a ground. Frame: the scene's.
LightPoint lightOf(const StreetLamp& lamp, double groundM);

} // namespace scenery
