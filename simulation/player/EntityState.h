// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include <glm/glm.hpp>

namespace simulation
{

/// Where an entity is and how it moves at one instant.
/// Frame: the scene's east-north-up; the position is that of the entity's reference point (for a vehicle the middle
/// of the rear axle, on the ground). Angles as in ISO 8855 and the scenario: heading counter-clockwise from east,
/// pitch positive nose *down*, roll positive right side down; applied in that order, heading first.
/// Units: metres, degrees, m/s.
struct EntityState
{
    std::string name;
    glm::dvec3 position{0.0};
    double headingDeg = 0.0; ///< -180…180
    double pitchDeg = 0.0;
    double rollDeg = 0.0;
    double speedMps = 0.0;
    glm::dvec3 velocity{0.0};      ///< m/s
    double odometerM = 0.0;        ///< distance covered since the start
    double wheelRotationDeg = 0.0; ///< 0…360, forward
    double steeringDeg = 0.0;      ///< of the front wheels, positive to the left

    /// How far the ground under each wheel lies above (+) the plane through the wheels' mean: the travel of its
    /// suspension. Front left, front right, rear left, rear right; 0 off the ground.
    std::array<double, 4> wheelTravelM{};
    bool isOnGround = false;

    /// Columns: the entity's forward, left and up in the scene's frame.
    glm::dmat3 bodyToLocal() const;

    /// Clockwise from north, 0…360.
    double compassDeg() const;
};

} // namespace simulation
