// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/nodes/Pose.h"
#include "simulation/player/SceneFrame.h"

namespace trainer
{

/// How a chase camera follows. Units: metres, seconds.
struct ChaseSettings
{
    double distanceM = 9.0;
    double heightM = 2.8;       ///< above the body's origin
    double lookAtHeightM = 0.9; ///< above the body's origin
    double leadM = 1.0;         ///< how far ahead of the origin it looks
    double turnTimeS = 0.45;    ///< time constant for following turns and climbs
    double clearanceM = 1.0;    ///< at least this far above the ground, at the eye and on the way to the body
    double settleTimeS = 0.8;   ///< time constant for coming down again after a rise of the ground

    static ChaseSettings forCar() { return {}; }
    static ChaseSettings forAircraft() { return {26.0, 6.5, 1.6, 4.0, 0.9, 6.0, 2.0}; }
};

/// An eye behind and above a body. It follows the body's course smoothly (first order, exact for any step, so it is
/// the same at any frame rate up to rounding), keeps its horizon level, does not follow rolls, and is never below
/// the ground: where ground would come between it and the body it rises at once, and settles slowly.
/// Invariant: after every update the eye is at least clearanceM above the ground, where there is ground.
/// Frame: world. Deterministic: depends on the updates given, nothing else. Threads: one.
class ChaseCamera
{
public:
    explicit ChaseCamera(const ChaseSettings& settings) : _settings(settings) {}

    /// The eye `dtS` after the one before; the first update starts right behind the body. `ground` may be empty.
    scenery::Pose update(const scenery::Pose& body, double dtS, const simulation::GroundProvider& ground);

private:
    glm::dvec3 follow(const glm::dvec3& forward, double dtS);
    double liftFor(const glm::dvec3& eye, const glm::dvec3& target,
                   const simulation::GroundProvider& ground) const;

    ChaseSettings _settings;
    glm::dvec3 _course{0.0}; ///< smoothed forward direction; zero before the first update
    double _liftM = 0.0;     ///< what the ground makes it rise
};

} // namespace trainer
