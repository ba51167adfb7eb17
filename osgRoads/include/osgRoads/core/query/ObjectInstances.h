// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// An object where it stands, or a stretch of one that goes on without a break. Units: metres, radians.
struct ObjectInstance
{
    double s = 0.0, t = 0.0, z = 0.0; ///< z above the road
    double headingRad = 0.0;          ///< relative to the road
    double pitchRad = 0.0, rollRad = 0.0;
    double length = 0.0, width = 0.0, height = 0.0, radius = 0.0;
    bool isStretch = false; ///< from (s, t, z) to (sEnd, tEnd, zEnd), with widthEnd and heightEnd there
    double sEnd = 0.0, tEnd = 0.0, zEnd = 0.0, widthEnd = 0.0, heightEnd = 0.0;
};

/// Returns an object once, or as its repeats have it; at most kMostInstances.
/// Source: ASAM OpenDRIVE 1.8, 13.4 (repeating objects).
std::vector<ObjectInstance> objectInstances(const RoadObject& object);

inline constexpr std::size_t kMostInstances = 100000;

/// Returns the corners of an outline in the inertial frame: on the ground, heights apart.
/// Source: ASAM OpenDRIVE 1.8, 13.3 (object outline).
std::vector<glm::dvec3> outlineCorners(const Road& road, const RoadObject& object,
                                       const ObjectOutline& outline);

} // namespace osgRoads::core
