// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <glm/glm.hpp>

#include "simulation/contact/Obstacle.h"

namespace simulation
{

/// A vehicle met something. Frame: the scene's. Units: seconds, metres, m/s.
struct Impact
{
    double timeS = 0.0;        ///< of the vehicle, when it began
    double lastS = 0.0;        ///< when they touched last
    double speedMps = 0.0;     ///< of the vehicle, before
    double closingMps = 0.0;   ///< of both against each other, across the contact
    glm::dvec3 place{0.0};     ///< where they met
    glm::dvec3 direction{0.0}; ///< unit vector of the vehicle's motion before
    ObstacleKind kind = ObstacleKind::thing;
    std::string name;      ///< of what was hit
    bool hasGiven = false; ///< it broke, or gave way
    /// what of the vehicle it broke: "propeller broken, engine stopped"; empty: nothing
    std::string damage{};
};

/// An impact in a line, for people: "after 12.30 s at 54 km/h into a tree (oak) at 120.3, 44.0", and what it
/// broke.
/// `startS`: of the simulation, when the vehicle's time was 0.
std::string textOf(const Impact& impact, double startS = 0.0);

} // namespace simulation
