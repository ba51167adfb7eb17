// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

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

    /// Behind a vehicle and what it tows: `behindM`: how far they reach behind the vehicle's origin,
    /// `heightM`: how high.
    static ChaseSettings forTrain(double behindM, double heightM)
    {
        ChaseSettings settings;
        settings.distanceM = std::max(settings.distanceM, behindM + 8.0);
        settings.heightM = std::max(settings.heightM, heightM + 1.3);
        return settings;
    }

    /// An eye high above a car, behind it: it looks down on the road ahead, as far as the car stays in the
    /// picture. From 30 m it looks down by 26°, from 300 m by 55°.
    static ChaseSettings above(double heightM)
    {
        const double behindM = std::max(0.5 * heightM, std::min(1.2 * heightM, 36.0));
        const double downRad = std::atan2(heightM, behindM) - kLowInPictureRad;
        const double leadM = std::min(heightM / std::tan(downRad) - behindM, 60.0);
        return {behindM, heightM, 0.0, leadM, 1.5, 0.3 * heightM, 2.0};
    }

    static constexpr double kLowInPictureRad =
        0.244; ///< 14°: of 20° from the middle of the usual picture to its edge
};

/// A camera behind and above a body. It follows the course of the body with a first-order lag (exact for any
/// step, so the same at any frame rate up to rounding), keeps its horizon level and does not follow rolls.
/// Where ground would hide the body it rises at once, and comes down slowly.
/// Invariant: after each update the camera is at least clearanceM above the ground, where there is ground.
/// Frame: world. Deterministic: depends on the updates only. Threads: one.
class ChaseCamera
{
public:
    explicit ChaseCamera(const ChaseSettings& settings) : _settings(settings) {}

    /// Returns the camera pose `dtS` after the last one; the first update starts behind the body. `ground`
    /// may be empty.
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
