// SPDX-License-Identifier: Apache-2.0
#include "OwnshipEye.h"

#include "scenery/nodes/AircraftModel.h"
#include "scenery/nodes/CarModel.h"

namespace trainer
{

namespace
{

glm::dvec3 ownEye(const ScenarioObject& ownship, double eyeHeightM)
{
    return ownship.isAirborne() ? pilotEyeInAircraft() : driverEyeInCar(eyeHeightM);
}

} // namespace

OwnshipEye::OwnshipEye(const ScenarioObject& ownship, const PlayRequest& request, GroundProvider ground)
    : _eye(request.eye),
      _eyeInBody(ownEye(ownship, request.eyeHeightM)),
      _chase(ownship.isAirborne() ? ChaseSettings::forAircraft() : ChaseSettings::forCar()),
      _ground(std::move(ground))
{
}

Pose OwnshipEye::update(const EntityState& state, double dtS)
{
    const Pose body = poseOf(state);
    if (_eye == EyePoint::chase) return _chase.update(body, dtS, _ground);
    return eyeInBody(body, _eyeInBody);
}

} // namespace trainer
