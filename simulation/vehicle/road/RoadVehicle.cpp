// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/RoadVehicle.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/BedGround.h"
#include "simulation/vehicle/StandardAtmosphere.h"
#include "simulation/vehicle/road/Roughness.h"
#include "simulation/vehicle/road/Tyre.h"

namespace simulation
{

namespace
{

constexpr double kFastestMps = 150.0;
constexpr double kFarthestM = 1e7;
constexpr double kFastestRadps = 20.0; ///< of a tumbling body; faster turning is cut
constexpr double kOverCosine = 0.35;   ///< of the tilt at which a vehicle lies on its side
constexpr double kOverTimeS = 0.3;

bool isFinite(const glm::dvec3& vector)
{
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

bool isLeft(std::size_t wheel)
{
    return wheel % 2 == 0;
}

} // namespace

RoadVehicle::RoadVehicle(std::shared_ptr<const RoadVehicleData> data, std::shared_ptr<const EarthFrame> earth,
                         std::shared_ptr<BodyWorld> world)
    : _data(std::move(data)),
      _earth(std::move(earth)),
      _world(world ? std::move(world) : std::make_shared<BodyWorld>()),
      _mass(massProperties(*_data)),
      _body(_world->add(_mass, _data->hull)),
      _meeting({_world, _body, &_data->hull, _mass.centre, _mass.massKg}),
      _restN(restLoads(*_data)),
      _drivetrain(*_data)
{
    for (std::size_t i = 0; i < 2; ++i)
    {
        const AxleData& axle = _data->axles[i];
        _hubZM[i] = axle.tyre.radiusM - _restN[i] / (axle.tyresPerSide * axle.tyre.springNPerM);
    }
    _motion.position.z = _mass.centre.z;
    _world->place(_body, _motion);
}

void RoadVehicle::crash(std::string_view reason)
{
    if (_status.condition != VehicleCondition::sound) return;
    _status = {VehicleCondition::crashed, reason};
    _drivetrain.stop();
}

/// It stands still at the last good state.
void RoadVehicle::fail(std::string_view reason)
{
    _status = {VehicleCondition::failed, reason};
    _motion = _before;
    _motion.velocity = _motion.rates = glm::dvec3(0.0);
    _acceleration = glm::dvec3(0.0);
    for (RoadWheel& wheel : _wheels)
    {
        wheel.radps = wheel.travelMps = wheel.loadN = 0.0;
        wheel.bend = wheel.forceN = glm::dvec2(0.0);
        if (!std::isfinite(wheel.travelM)) wheel.travelM = 0.0;
        if (!std::isfinite(wheel.rotationRad)) wheel.rotationRad = 0.0;
    }
    _drivetrain.stop();
    _world->setGravity(_body, glm::dvec3(0.0));
    _world->place(_body, _motion);
}

RoadVehicle::Axes RoadVehicle::axes() const
{
    const glm::dmat3 body = glm::mat3_cast(_motion.bodyToScene);
    return {body[0], body[1], body[2]};
}

/// The place of a hub. Frame: the scene's.
glm::dvec3 RoadVehicle::hubOf(std::size_t wheel) const
{
    const AxleData& axle = _data->axles[wheel / 2];
    const glm::dvec3 place(axle.xM, (isLeft(wheel) ? 0.5 : -0.5) * axle.trackM,
                           _hubZM[wheel / 2] + _wheels[wheel].travelM);
    return _motion.position + _motion.bodyToScene * (place - _mass.centre);
}

/// Turns the road wheels at the rate that an arm can; the inner wheel more (Ackermann).
void RoadVehicle::steer()
{
    const SteeringData& steering = _data->steering;
    const double wanted =
        _status.condition == VehicleCondition::sound
            ? inputOf(_inputs, RoadInput::steering) * foundation::radiansOf(steering.lockDeg)
            : _steerRad;
    const double most = foundation::radiansOf(steering.rateDegPerS) / steering.ratio * kStepS;
    _steerRad += std::clamp(wanted - _steerRad, -most, most);
    for (std::size_t i = 0; i < 4; ++i)
    {
        const AxleData& axle = _data->axles[i / 2];
        const double tangent = std::tan(_steerRad * axle.steersShare);
        const double aside = (isLeft(i) ? 0.5 : -0.5) * axle.trackM;
        _wheels[i].steerRad =
            std::atan2(tangent * _data->wheelbaseM(), _data->wheelbaseM() - tangent * aside);
    }
}

/// Drag along and across the body.
glm::dvec3 RoadVehicle::airForce(const Air& air) const
{
    const double heightM = _earth ? _earth->placeAt(_motion.position).geodetic.heightM : _motion.position.z;
    const AirSample sample = air.at(_motion.position, heightM, _timeS);
    const glm::dvec3 inBody = glm::conjugate(_motion.bodyToScene) * (_motion.velocity - sample.windMps);
    const glm::dvec3 area(_data->air.dragAreaM2, _data->air.sideAreaM2, _data->air.sideAreaM2);
    return _motion.bodyToScene * (-0.5 * sample.densityKgPerM3 * glm::length(inBody) * area * inBody);
}

void RoadVehicle::prepare(const Ground& ground, const Air& air)
{
    if (_status.condition == VehicleCondition::failed) return;
    _before = _motion;
    _gravity = _earth ? _earth->gravityAt(_motion.position)
                      : glm::dvec3(0.0, 0.0, -foundation::kStandardGravityMps2);
    _world->setGravity(_body, _gravity);
    steer();
    _drivetrain.choose(_inputs, shaftRadps(), kStepS);
    _airForce = airForce(air);
    const BedGround bed(ground);
    lookAtGround(bed);
    lookAtWater(ground, bed.hasWater());
    if (std::none_of(_wheels.begin(), _wheels.end(), [](const RoadWheel& w) { return w.ground.isKnown(); }))
        return fail("there is no ground below it");
    liftOutOfGround();
    lookAtObstacles();
}

double RoadVehicle::shaftRadps() const
{
    double sum = 0.0, shares = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        sum += _data->axles[i / 2].driveShare * _wheels[i].radps;
        shares += _data->axles[i / 2].driveShare;
    }
    return shares > 0.0 ? sum / shares : 0.0;
}

/// Takes what the world has made of the forces.
void RoadVehicle::end(double stepS)
{
    if (_status.condition == VehicleCondition::failed) return;
    _motion = _world->motion(_body);
    const double turning = glm::length(_motion.rates);
    if (turning > kFastestRadps)
    {
        _motion.rates *= kFastestRadps / turning;
        _world->place(_body, _motion);
    }
    const SolidHit hit = _world->hit(_body);
    _meeting.note(hit, _timeS + kStepS, _before.velocity);
    if (hit.closingMps > _data->hull.crashesAtMps)
    {
        if (hit.obstacle && hit.obstacleMps == hit.closingMps)
            crash(_meeting.obstacles().reason(*hit.obstacle));
        else if (hit.mover && hit.moverMps == hit.closingMps)
            crash(_meeting.obstacles().reason(ObstacleMeeting::numberOf(*hit.mover)));
        else
            crash("it hit something hard");
    }
    const bool isOver = glm::dot(axes().up, -_gravity) < kOverCosine * glm::length(_gravity);
    _overS = isOver ? _overS + stepS : 0.0;
    if (_overS > kOverTimeS && hit.touches) crash("it rolled over");
}

bool RoadVehicle::isComputable() const
{
    const glm::dquat& q = _motion.bodyToScene;
    const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const bool areWheels = std::all_of(_wheels.begin(), _wheels.end(),
                                       [](const RoadWheel& wheel)
                                       {
                                           return std::isfinite(wheel.travelM) &&
                                                  std::isfinite(wheel.radps) && std::isfinite(wheel.bend.x) &&
                                                  std::isfinite(wheel.bend.y);
                                       });
    return isFinite(_motion.position) && isFinite(_motion.velocity) && isFinite(_motion.rates) && areWheels &&
           std::abs(square - 1.0) < 1e-3 && glm::length(_motion.velocity) < kFastestMps &&
           glm::length(_motion.position) < kFarthestM && _drivetrain.isFinite();
}

void RoadVehicle::finish()
{
    _timeS = _startS + static_cast<double>(++_step) * kStepS;
    if (_status.condition == VehicleCondition::failed) return;
    _acceleration = glm::conjugate(_motion.bodyToScene) * ((_motion.velocity - _before.velocity) / kStepS);
    if (!isComputable()) fail("its motion cannot be computed any further");
}

void RoadVehicle::stepTogether(std::span<RoadVehicle* const> vehicles, const Ground& ground, const Air& air)
{
    constexpr double kShortS = kStepS / kSubsteps;
    for (RoadVehicle* const vehicle : vehicles)
        vehicle->prepare(ground, air);
    for (int i = 0; i < kSubsteps && !vehicles.empty(); ++i)
    {
        for (RoadVehicle* const vehicle : vehicles)
            vehicle->press(kShortS);
        vehicles.front()->_world->step(kShortS);
        for (RoadVehicle* const vehicle : vehicles)
            vehicle->end(kShortS);
    }
    for (RoadVehicle* const vehicle : vehicles)
        vehicle->finish();
}

void RoadVehicle::step(const Ground& ground, const Air& air)
{
    RoadVehicle* const self = this;
    stepTogether({&self, 1}, ground, air);
}

} // namespace simulation
