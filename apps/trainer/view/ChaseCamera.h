// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "scenery/nodes/Pose.h"
#include "simulation/player/SceneFrame.h"

namespace trainer
{

/// The settings of a chase camera. Units: metres, seconds.
struct ChaseSettings
{
    double distanceM = 9.0;
    double heightM = 2.8;       ///< above the body's origin
    double lookAtHeightM = 0.9; ///< above the body's origin
    double leadM = 1.0;         ///< how far ahead of the origin it looks
    double turnTimeS = 0.45;    ///< time constant for following turns and climbs
    double clearanceM = 1.0;    ///< least height above the ground, at the camera and on the line to the body
    double settleTimeS = 0.8;   ///< time constant for coming down after a rise of the ground

    static ChaseSettings forCar() { return {}; }
    static ChaseSettings forAircraft() { return {26.0, 6.5, 1.6, 4.0, 0.9, 6.0, 2.0}; }

    /// An eye high above a car, which looks down on the road ahead: by 22° from 30 m, and from 300 m by 55°,
    /// so that the car stays in the picture.
    static ChaseSettings above(double heightM)
    {
        return {0.5 * heightM, heightM, 0.0, std::min(2.0 * heightM, 60.0), 1.5, 0.3 * heightM, 2.0};
    }
};

/// A camera behind and above a body. It follows the course of the body with a first-order lag (exact for any step, so
/// the same at any frame rate up to rounding), keeps its horizon level and does not follow rolls. Where ground would
/// hide the body it rises at once, and comes down slowly.
/// Invariant: after each update the camera is at least clearanceM above the ground, where there is ground.
/// Frame: world. Deterministic: depends on the updates only. Threads: one.
class ChaseCamera
{
public:
    explicit ChaseCamera(const ChaseSettings& settings) : _settings(settings) {}

    /// Returns the camera pose `dtS` after the last one; the first update starts behind the body. `ground` may be
    /// empty.
    scenery::Pose update(const scenery::Pose& body, double dtS, const simulation::GroundProvider& ground);

private:
    glm::dvec3 follow(const glm::dvec3& forward, double dtS);
    double liftFor(const glm::dvec3& eye, const glm::dvec3& target,
                   const simulation::GroundProvider& ground) const;

    ChaseSettings _settings;
    glm::dvec3 _course{0.0}; ///< smoothed forward direction; zero before the first update
    double _liftM = 0.0;     ///< rise caused by the ground
};

} // namespace trainer
