// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "PlayRequest.h"
#include "simulation/player/ScenarioPlayer.h"
#include "view/ChaseCamera.h"

namespace trainer
{

/// The eye of the ownship, which is the scenario's first entity.
/// Frame: world. Deterministic: depends on the updates given, nothing else.
class OwnshipEye
{
public:
    OwnshipEye(const simulation::ScenarioObject& ownship, const FrameRequest& frames,
               simulation::GroundProvider ground);

    /// The eye for a state that is `dtS` later than the one before.
    scenery::Pose update(const simulation::EntityState& state, double dtS);

private:
    EyePoint _eye;
    glm::dvec3 _eyeInBody;
    ChaseCamera _chase;
    simulation::GroundProvider _ground;
};

} // namespace trainer
