// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "simulation/vehicle/road/BodyWorld.h"
#include "simulation/vehicle/road/ObstacleMeeting.h"

namespace simulation
{

/// The upright box around a box of a hull, turned with the vehicle. `centre`: of mass, in the hull's frame.
HullPlan hullPlanOf(const HullBox& box, const glm::dvec3& centre, const SolidMotion& motion);

/// How the hull of a vehicle of any kind meets what stands and moves around it: what stands fast goes into
/// the world of bodies, what gives acts by an impulse.
class HullMeeting
{
public:
    /// The vehicle's body in a world.
    struct Body
    {
        std::shared_ptr<BodyWorld> world;
        int number = 0;
        const HullData* hull = nullptr; ///< must outlive this
        glm::dvec3 centre{0.0};         ///< of mass, in the hull's frame
        double massKg = 0.0;
    };

    HullMeeting() = default; ///< without a body yet: look() needs one where anything may be near
    explicit HullMeeting(Body body) : _body(std::move(body)) {}
    void setBody(Body body) { _body = std::move(body); }

    ObstacleMeeting& obstacles() { return _obstacles; }
    const ObstacleMeeting& obstacles() const { return _obstacles; }
    std::span<const int> touchedMovers() const { return _touchedMovers; }

    /// Before a step, with the body in its place: finds what is near. `timeS`: at the end of the step.
    /// Returns whether the body has another speed for what gave way.
    bool look(const SolidMotion& motion, double timeS, double stepS);

    /// Whether anything stood or moved near in the last look: short steps are needed.
    bool isNear() const { return _isNear; }
    bool hasMovers() const { return _hasMovers; }

    /// Keeps what was touched, and how hard. `velocity`: of the vehicle before.
    void note(const SolidHit& hit, double timeS, const glm::dvec3& velocity);

    static constexpr double kLookFurtherM = 0.5; ///< than a step takes it

private:
    bool lookAtMovers(const SolidMotion& motion, double reachM);
    void meetGiving(const Obstacle& obstacle, std::uint32_t number, const SolidMotion& looked);

    Body _body;
    ObstacleMeeting _obstacles;
    bool _hasMovers = false, _isNear = false;
    std::vector<int> _touchedMovers;
    double _timeS = 0.0, _stepS = 0.0; ///< of the look
};

} // namespace simulation
