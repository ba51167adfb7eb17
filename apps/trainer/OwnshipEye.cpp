// SPDX-License-Identifier: Apache-2.0
#include "OwnshipEye.h"

#include "scenery/nodes/AircraftModel.h"
#include "scenery/nodes/CarModel.h"

namespace trainer
{

namespace
{

glm::dvec3 ownEye(const simulation::ScenarioObject& ownship, double eyeHeightM)
{
    return ownship.isAirborne() ? scenery::pilotEyeInAircraft() : scenery::driverEyeInCar(eyeHeightM);
}

} // namespace

OwnshipEye::OwnshipEye(const simulation::ScenarioObject& ownship, const FrameRequest& frames,
                       simulation::GroundProvider ground)
    : _eye(frames.eye),
      _eyeInBody(ownEye(ownship, frames.eyeHeightM)),
      _chase(ownship.isAirborne() ? ChaseSettings::forAircraft() : ChaseSettings::forCar()),
      _ground(std::move(ground))
{
}

scenery::Pose OwnshipEye::update(const simulation::EntityState& state, double dtS)
{
    const scenery::Pose body = scenery::poseOf(state);
    if (_eye == EyePoint::chase) return _chase.update(body, dtS, _ground);
    return scenery::eyeInBody(body, _eyeInBody);
}

} // namespace trainer
