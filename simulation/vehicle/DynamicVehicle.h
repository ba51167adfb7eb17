// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <foundation/Result.h>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "simulation/contact/Impact.h"
#include "simulation/contact/MovingObstacle.h"
#include "simulation/state/EntityState.h"
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

class ObstacleMap;

/// Condition and its reason.
struct VehicleStatus
{
    VehicleCondition condition = VehicleCondition::sound;
    std::string_view reason; ///< of a text that lives as long as the program; empty when sound
};

/// Position and motion of a vehicle. No number is ever NaN or infinite.
/// Frames: the scene's east-north-up; the body's x forward, y left, z up (ISO 8855). Units: metres, m/s,
/// rad/s.
struct VehicleState
{
    double timeS = 0.0;
    glm::dvec3 position{0.0}; ///< of the centre of mass
    glm::dvec3 velocity{0.0}; ///< over the ground
    glm::dquat bodyToScene{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 bodyRates{0.0}; ///< relative to the ground, body axes
    bool isOnGround = false;
};

/// Where and how a vehicle begins.
/// Frame: the scene's east-north-up, as EntityState: the place is that of the reference point. Units: metres,
/// radians, m/s.
struct VehicleStart
{
    glm::dvec3 position{0.0};
    double headingRad = 0.0; ///< counter-clockwise from east
    double speedMps = 0.0;
    bool isInAir = false; ///< it flies there; else it stands or rolls on the ground below the position
};

/// Anything that moves by its own physics. Whoever controls it writes inputs; whoever shows it reads the
/// state.
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

    /// Puts the vehicle where it begins, at the time 0, sound and as steady as it can be there.
    /// Errors: no such beginning (in water, inside the ground, too slow to fly), with the place; then the
    /// vehicle is as before.
    virtual foundation::Outcome begin(const VehicleStart& start, const Ground& ground, const Air& air) = 0;

    /// From now on it meets what stands in a scene; null: nothing does. A vehicle that knows no contact
    /// drives through.
    virtual void meet(std::shared_ptr<const ObstacleMap> /*obstacles*/) {}

    /// Until the next call it meets these, too, each from where it is now on; a vehicle that knows no contact
    /// drives through.
    virtual void meetMovers(std::span<const MovingObstacle> /*movers*/) {}

    /// The numbers of those that it touched in the last step, ascending.
    virtual std::span<const int> touchedMovers() const { return {}; }

    /// What it hit since it began, in the order of time.
    virtual std::span<const Impact> impacts() const { return {}; }

    /// The reference point of EntityState, from the centre of mass: on the ground below the rear axle, struts
    /// unloaded. Body axes.
    virtual glm::dvec3 referencePoint() const = 0;

    /// Writes what pictures and tables need besides the motion: wheels, steering, surfaces, airspeeds.
    virtual void writeParts(EntityState& entity) const = 0;

    virtual VehicleState state() const = 0;
    virtual VehicleStatus status() const = 0;
};

} // namespace simulation
