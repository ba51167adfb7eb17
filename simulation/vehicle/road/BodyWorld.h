// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "simulation/contact/MovingObstacle.h"
#include "simulation/contact/ObstacleMap.h"
#include "simulation/vehicle/Ground.h"
#include "simulation/vehicle/road/RoadVehicleData.h"

namespace simulation
{

/// Motion of a rigid body. Frames: the scene's; rates in the scene's axes. Units: metres, m/s, rad/s.
struct SolidMotion
{
    glm::dvec3 position{0.0}; ///< of the centre of mass
    glm::dquat bodyToScene{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 velocity{0.0};
    glm::dvec3 rates{0.0};
};

/// What a body hit in the last step.
struct SolidHit
{
    bool touches = false;
    double closingMps = 0.0; ///< the fastest closing speed among its contacts, before they were resolved

    std::optional<std::uint32_t> obstacle{}; ///< that it met hardest
    double obstacleMps = 0.0;                ///< closing speed there
    glm::dvec3 place{0.0};                   ///< where

    std::optional<int> mover{}; ///< that it met hardest, by its number
    double moverMps = 0.0;      ///< closing speed there
    glm::dvec3 moverPlace{0.0};
    std::vector<int> movers{}; ///< all that it touches, unsorted
};

/// Rigid bodies of boxes that meet each other, the ground and what stands on it: a world of Bullet in double
/// precision.
///
/// Forces are added before each step and hold for it alone. The ground is met only where a body has been
/// given a patch of it. One thread, a fixed order of bodies: the same calls give the same bytes.
class BodyWorld
{
public:
    BodyWorld();
    ~BodyWorld();
    BodyWorld(const BodyWorld&) = delete;
    BodyWorld& operator=(const BodyWorld&) = delete;

    /// Adds a body of boxes about its centre of mass; returns its number.
    int add(const RoadMassProperties& mass, const HullData& hull);

    void place(int body, const SolidMotion& motion);
    SolidMotion motion(int body) const;

    void setGravity(int body, const glm::dvec3& gravity);

    /// A force at a point given from the centre of mass, scene's axes. Units: N, metres.
    void push(int body, const glm::dvec3& force, const glm::dvec3& arm);

    /// Lays a patch of the ground below a body, or takes it away. The ground must answer as before while it
    /// lies.
    void layGround(int body, const Ground& ground, double reachM);
    void liftGround(int body);

    /// Lets things of a map stand around a body, by their numbers in ascending order. All bodies have one
    /// map, which must outlive the world.
    void stand(int body, const ObstacleMap& map, std::span<const std::uint32_t> numbers);

    /// Lets things that move by themselves be there, each where it is now, in place of those before; step()
    /// moves them on.
    void accompany(std::span<const MovingObstacle> movers);

    /// An impulse at a point given from the centre of mass, scene's axes, at once. Units: N s, metres.
    void strike(int body, const glm::dvec3& impulse, const glm::dvec3& arm);

    /// The speed along a unit vector that an impulse of 1 N s along it at a point changes there. Units: 1/kg.
    double inverseMassAt(int body, const glm::dvec3& arm, const glm::dvec3& direction) const;

    void step(double stepS);

    SolidHit hit(int body) const;

private:
    struct Parts;
    std::unique_ptr<Parts> _parts;
};

} // namespace simulation
