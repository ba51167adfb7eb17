// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scenery/nodes/Pose.h"
#include "simulation/player/SceneFrame.h"

namespace trainer
{

/// The settings of a camera beside the way. Units: metres.
struct RoadsideSettings
{
    double aheadM = 25.0; ///< of the body, when it is placed
    double asideM = 7.0;  ///< to the right
    double heightM = 1.7; ///< above the ground
    double mostM = 45.0;  ///< away from the body; farther, and it is placed anew
    double lookAtM = 0.9; ///< above the body's origin

    static RoadsideSettings kerb() { return {}; }
    static RoadsideSettings kerbOfWalker() { return {9.0, 4.5, 1.6, 22.0, 1.0}; }
    static RoadsideSettings tower() { return {40.0, 32.0, 14.0, 150.0, 1.0}; }
};

/// A camera that stands beside the way and turns after a body: a person at the kerb, or a tower. It stands
/// still until the body is too far away; then it stands ahead of the body again.
/// Frame: world. Deterministic: depends on the updates only. Threads: one.
class RoadsideCamera
{
public:
    explicit RoadsideCamera(const RoadsideSettings& settings) : _settings(settings) {}

    /// Returns the camera pose. `ground` may be empty: then heights count from the body's origin.
    scenery::Pose update(const scenery::Pose& body, const simulation::GroundProvider& ground);

private:
    RoadsideSettings _settings;
    std::optional<glm::dvec3> _eye;
};

} // namespace trainer
