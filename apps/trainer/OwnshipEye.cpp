// SPDX-License-Identifier: Apache-2.0
#include "OwnshipEye.h"

#include "scenery/nodes/AircraftModel.h"
#include "scenery/nodes/CarModel.h"

namespace trainer
{

namespace
{

constexpr double kDriverEyeM = 1.2, kAboveM = 30.0;

ChaseSettings chaseFor(const simulation::ScenarioObject& ownship, const FrameRequest& frames)
{
    if (frames.eye == EyePoint::above) return ChaseSettings::above(frames.eyeHeightM.value_or(kAboveM));
    return ownship.isAirborne() ? ChaseSettings::forAircraft() : ChaseSettings::forCar();
}

glm::dvec3 ownEye(const simulation::ScenarioObject& ownship, double eyeHeightM)
{
    return ownship.isAirborne() ? scenery::pilotEyeInAircraft() : scenery::driverEyeInCar(eyeHeightM);
}

} // namespace

OwnshipEye::OwnshipEye(const simulation::ScenarioObject& ownship, const FrameRequest& frames,
                       simulation::GroundProvider ground)
    : _isInside(frames.isInside()),
      _eyeInBody(ownEye(ownship, frames.eyeHeightM.value_or(kDriverEyeM))),
      _chase(chaseFor(ownship, frames)),
      _ground(std::move(ground))
{
}

scenery::Pose OwnshipEye::update(const simulation::EntityState& state, double dtS)
{
    const scenery::Pose body = scenery::poseOf(state);
    return _isInside ? scenery::eyeInBody(body, _eyeInBody) : _chase.update(body, dtS, _ground);
}

} // namespace trainer
