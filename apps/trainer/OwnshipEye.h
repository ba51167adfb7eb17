// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "PlayRequest.h"
#include "simulation/player/ScenarioPlayer.h"
#include "view/ChaseCamera.h"

namespace trainer
{

/// The camera position of the ownship, which is the first entity of the scenario.
/// Frame: world. Deterministic: depends on the updates only.
class OwnshipEye
{
public:
    OwnshipEye(const simulation::ScenarioObject& ownship, const FrameRequest& frames,
               simulation::GroundProvider ground);

    /// Returns the camera pose for a state `dtS` after the last one.
    scenery::Pose update(const simulation::EntityState& state, double dtS);

private:
    bool _isInside;
    glm::dvec3 _eyeInBody;
    ChaseCamera _chase;
    simulation::GroundProvider _ground;
};

} // namespace trainer
