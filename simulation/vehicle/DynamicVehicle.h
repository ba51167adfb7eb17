// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "simulation/vehicle/Air.h"
#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// How a vehicle is.
enum class VehicleCondition
{
    sound,
    crashed, ///< it hit something too hard; it still slides, without power
    failed   ///< its motion left what can be computed; it stands still at the last good state
};

/// Condition and its reason.
struct VehicleStatus
{
    VehicleCondition condition = VehicleCondition::sound;
    std::string_view reason; ///< of a text that lives as long as the program; empty when sound
};

/// Position and motion of a vehicle. No number is ever NaN or infinite.
/// Frames: the scene's east-north-up; the body's x forward, y left, z up (ISO 8855). Units: metres, m/s, rad/s.
struct VehicleState
{
    double timeS = 0.0;
    glm::dvec3 position{0.0}; ///< of the centre of mass
    glm::dvec3 velocity{0.0}; ///< over the ground
    glm::dquat bodyToScene{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 bodyRates{0.0}; ///< relative to the ground, body axes
    bool isOnGround = false;
};

/// Anything that moves by its own physics. Whoever controls it writes inputs; whoever shows it reads the state.
/// Determinism: the same inputs, ground and air give the same bytes. Threads: one at a time.
class DynamicVehicle
{
public:
    virtual ~DynamicVehicle() = default;

    /// Names of the inputs, in the order of inputs().
    virtual std::span<const std::string_view> inputNames() const = 0;

    /// The inputs of the next step. Numbers outside their range count as the nearest in it, NaN as 0.
    virtual std::span<double> inputs() = 0;

    /// The length of a step in seconds, the same for a vehicle's whole life.
    virtual double stepSeconds() const = 0;

    virtual void step(const Ground& ground, const Air& air) = 0;

    virtual VehicleState state() const = 0;
    virtual VehicleStatus status() const = 0;
};

} // namespace simulation
