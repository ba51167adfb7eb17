// SPDX-License-Identifier: Apache-2.0
#include "OwnshipEye.h"

#include <foundation/Angle.h>
#include <glm/gtc/matrix_transform.hpp>

namespace trainer
{

namespace
{

constexpr double kAboveM = 30.0, kMapM = 2000.0;

const glm::dmat3 kNorthUp({0.0, 0.0, -1.0}, {-1.0, 0.0, 0.0},
                          {0.0, 1.0, 0.0}); ///< forward is down, left west

ChaseSettings chaseFor(const simulation::ScenarioObject& ownship, const TrainSize& train,
                       const FrameRequest& frames)
{
    if (frames.eye == EyePoint::above) return ChaseSettings::above(frames.eyeHeightM.value_or(kAboveM));
    if (ownship.isAirborne()) return ChaseSettings::forAircraft();
    return ChaseSettings::forTrain(train.behindM, train.heightM);
}

RoadsideSettings roadsideFor(const simulation::ScenarioObject& ownship, const FrameRequest& frames)
{
    const bool walks = std::holds_alternative<simulation::Pedestrian>(ownship.object);
    RoadsideSettings settings = frames.eye == EyePoint::tower ? RoadsideSettings::tower()
                                : walks                       ? RoadsideSettings::kerbOfWalker()
                                                              : RoadsideSettings::kerb();
    settings.heightM = frames.eyeHeightM.value_or(settings.heightM);
    return settings;
}

/// Heading counter-clockwise from east, pitch upwards.
scenery::Pose poseOf(const FreeEye& eye)
{
    const glm::dmat4 turned =
        glm::rotate(glm::dmat4(1.0), foundation::radiansOf(eye.headingDeg), {0.0, 0.0, 1.0});
    const glm::dmat4 tilted = glm::rotate(turned, -foundation::radiansOf(eye.pitchDeg), {0.0, 1.0, 0.0});
    return {eye.place, glm::dmat3(tilted)};
}

} // namespace

OwnshipEye::OwnshipEye(const simulation::ScenarioObject& ownship, const TrainSize& train,
                       const glm::dvec3& eyeInBody, const FrameRequest& frames,
                       simulation::GroundProvider ground)
    : _eye(frames.eye),
      _eyeInBody(eyeInBody),
      _free(poseOf(frames.freeEye)),
      _chase(chaseFor(ownship, train, frames)),
      _roadside(roadsideFor(ownship, frames)),
      _ground(std::move(ground)),
      _mapHeightM(frames.eyeHeightM.value_or(kMapM))
{
    if (!ownship.isAirborne()) _eyeInBody.z = frames.eyeHeightM.value_or(_eyeInBody.z);
}

scenery::Pose OwnshipEye::update(const simulation::EntityState& state, double dtS)
{
    const scenery::Pose body = scenery::poseOf(state);
    switch (_eye)
    {
    case EyePoint::chase:
    case EyePoint::above:
        return _chase.update(body, dtS, _ground);
    case EyePoint::tower:
    case EyePoint::kerb:
        return _roadside.update(body, _ground);
    case EyePoint::free:
        return _free;
    case EyePoint::map:
        return {body.positionWorld + glm::dvec3(0.0, 0.0, _mapHeightM), kNorthUp};
    default:
        return scenery::eyeInBody(body, _eyeInBody);
    }
}

} // namespace trainer
