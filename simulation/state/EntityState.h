// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "simulation/road/RoadPlace.h"
#include "simulation/scenario/AppearanceActions.h"
#include "simulation/state/AircraftParts.h"
#include "simulation/state/VehicleReadings.h"

namespace simulation
{

/// A lamp that an action has switched. Units: seconds.
struct LampState
{
    LightMode mode = LightMode::off;
    double sinceS = 0.0, onS = 0.5, offS = 0.5;
    bool isLit = false; ///< now: a flashing one begins lit
};

/// The position and the motion of an entity at one instant.
/// Frame: the scene's east-north-up; the position is that of the reference point (for a vehicle the middle of
/// the rear axle, on the ground). Angles as in ISO 8855 and in the scenario: heading counter-clockwise from
/// east, pitch positive nose *down*, roll positive right side down, applied in this order.
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

    /// The travel of each suspension: the height of the ground under the wheel above (+) the mean plane of
    /// the four wheels. Front left, front right, rear left, rear right; 0 when airborne.
    std::array<double, 4> wheelTravelM{};
    /// How far each wheel has turned by its own physics, in the same order, 0…360, forward; nothing: wheels
    /// roll with the odometer.
    std::optional<std::array<double, 4>> wheelTurnDeg{};
    bool isOnGround = false;
    std::optional<AircraftParts> aircraft; ///< of one that flies by its own physics
    std::optional<RoadPlace> place;        ///< on the road network; nothing without one
    /// the same by the lane that is under it: one that changes its lane has the new one already
    std::optional<RoadPlace> laneUnder;
    bool isAtEndOfRoad = false;
    glm::dvec3 acceleration{0.0}; ///< m/s², difference of velocities between steps; on a road network only
    /// false before AddEntityAction and after DeleteEntityAction: not there for conditions and collisions
    bool isPresent = true;
    bool isVisible = true; ///< in pictures
    std::map<std::string, LampState>
        lamps{}; ///< that light states have switched, by the names of the standard
    /// the states of doors, motions … that animations have set, by the names of the standard
    std::map<std::string, double> animations{};
    std::vector<int> collidesWith;             ///< indices of the entities whose boxes overlap this one's
    std::string roadUnder{};                   ///< the id of the road of `laneUnder`, where a player tells it
    std::optional<VehicleReadings> readings{}; ///< of one with physics, and of aircraft in a known wind

    /// The rotation from the body to the scene. Its columns are forward, left and up.
    glm::dmat3 bodyToLocal() const;

    /// The course, clockwise from north, 0…360.
    double compassDeg() const;
};

} // namespace simulation
