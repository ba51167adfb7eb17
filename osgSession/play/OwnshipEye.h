// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "request/PlayRequest.h"
#include "simulation/player/ScenarioPlayer.h"
#include "view/ChaseCamera.h"
#include "view/RoadsideCamera.h"
#include "view/WatchedEntity.h"

namespace trainer
{

/// The camera position by --eye: in the entity that is watched, behind, above or beside it, or where the
/// request says.
/// Frame: world. Deterministic: depends on the updates only.
class OwnshipEye
{
public:
    /// `ownship`: the entity that is watched; `train`: it and what it tows; `eyeInBody`: of its driver or
    /// pilot.
    OwnshipEye(const simulation::ScenarioObject& ownship, const TrainSize& train, const glm::dvec3& eyeInBody,
               const FrameRequest& frames, simulation::GroundProvider ground);

    /// Returns the camera pose for a state `dtS` after the last one.
    scenery::Pose update(const simulation::EntityState& state, double dtS);

    /// Moves the free eye.
    void setFree(const scenery::Pose& pose) { _free = pose; }

    /// Lets the map be seen from another height. Units: m.
    void setMapHeight(double heightM) { _mapHeightM = heightM; }
    double mapHeightM() const { return _mapHeightM; }

private:
    EyePoint _eye;
    glm::dvec3 _eyeInBody;
    scenery::Pose _free;
    ChaseCamera _chase;
    RoadsideCamera _roadside;
    simulation::GroundProvider _ground;
    double _mapHeightM;
};

} // namespace trainer
