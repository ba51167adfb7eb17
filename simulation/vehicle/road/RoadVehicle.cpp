// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/RoadVehicle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>

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
constexpr double kMostLoad = 15.0;     ///< over the load at rest
constexpr double kHullNearM = 0.08;    ///< between hull and ground, from where on the hull meets it
constexpr double kDeepestShare = 0.9;  ///< of the radius; deeper wheels are lifted out
constexpr double kOverCosine = 0.35;   ///< of the tilt at which a vehicle lies on its side
constexpr double kOverTimeS = 0.3;
constexpr double kTyreCosine =
    0.2; ///< of the angle between wheel and ground, below which a tyre carries nothing
constexpr double kAbsFall = 25.0, kAbsRise = 10.0; ///< of the share of the brakes, in a second
constexpr double kAbsWatches = 0.6;                ///< of its slip, from where on it holds
constexpr double kAbsGain = 1.0;                   ///< of the tyre's torque, over the slip

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
      _restN(restLoads(*_data)),
      _drivetrain(*_data)
{
    _body = _world->add(_mass, _data->hull);
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

/// Asks for the ground below all wheels and below the corners of the hull, where a step takes them.
void RoadVehicle::lookAtGround(const Ground& ground)
{
    std::array<glm::dvec3, 4 * WheelGround::kMostPoints + 8> points;
    std::array<GroundPoint, points.size()> answers;
    std::array<std::size_t, 4> counts{};
    std::size_t count = 0;
    const Axes body = axes();
    for (std::size_t i = 0; i < 4; ++i)
    {
        RoadWheel& wheel = _wheels[i];
        const RoadTyreData& tyre = _data->axles[i / 2].tyre;
        glm::dvec3 forward = std::cos(wheel.steerRad) * body.forward + std::sin(wheel.steerRad) * body.left;
        forward.z = 0.0;
        const double length = glm::length(forward);
        forward = length > 1e-3 ? forward / length : glm::dvec3(1.0, 0.0, 0.0);
        const auto asked = wheel.ground.pointsFor(hubOf(i), forward, tyre.radiusM, tyre.widthM,
                                                  glm::dot(_motion.velocity, forward) * kStepS);
        std::copy(asked.begin(), asked.end(), points.begin() + static_cast<std::ptrdiff_t>(count));
        counts[i] = asked.size();
        count += asked.size();
    }
    const std::size_t firstCorner = count;
    double reach = 0.0;
    const auto addCorners = [&](const HullBox& box)
    {
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
            {
                glm::dvec3 corner = box.place - _mass.centre + box.sizeM * glm::dvec3(x, y, -0.5);
                reach = std::max(reach, glm::length(glm::dvec2(corner)) + box.sizeM.z);
                points[count++] = _motion.position + _motion.bodyToScene * corner + _motion.velocity * kStepS;
            }
    };
    addCorners(_data->hull.boxes.front());
    ground.heightsBelow({points.data(), count}, {answers.data(), count});
    std::size_t first = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        _wheels[i].ground.take({answers.data() + first, counts[i]});
        first += counts[i];
    }
    double nearest = body.up.z > 0.7 ? 1e9 : -1.0;
    for (std::size_t i = firstCorner; i < count; ++i)
        if (answers[i].isKnown) nearest = std::min(nearest, points[i].z - answers[i].heightM);
    if (nearest < kHullNearM)
        _world->layGround(_body, ground, reach + 0.5);
    else
        _world->liftGround(_body);
}

/// Wheels far below the ground (a cliff, a start inside a hill) are lifted, without speed of their own.
void RoadVehicle::liftOutOfGround()
{
    double deepest = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const RoadTyreData& tyre = _data->axles[i / 2].tyre;
        if (!_wheels[i].ground.isKnown()) continue;
        const WheelContact contact = _wheels[i].ground.contactOf(hubOf(i), tyre.radiusM);
        deepest = std::max(deepest, contact.depthM - (1.0 + kDeepestShare) * tyre.radiusM);
    }
    if (deepest <= 0.0) return;
    crash("it hit the ground");
    _motion.position.z += deepest;
    _motion.velocity.z = std::max(0.0, _motion.velocity.z);
    _world->place(_body, _motion);
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
    _gravity = _earth ? _earth->gravityAt(_motion.position) : glm::dvec3(0.0, 0.0, -kStandardGravity);
    _world->setGravity(_body, _gravity);
    steer();
    _drivetrain.choose(_inputs, shaftRadps(), kStepS);
    _airForce = airForce(air);
    lookAtGround(ground);
    if (std::none_of(_wheels.begin(), _wheels.end(), [](const RoadWheel& w) { return w.ground.isKnown(); }))
        return fail("there is no ground below it");
    liftOutOfGround();
}

double RoadVehicle::springForce(std::size_t index) const
{
    const AxleData& axle = _data->axles[index / 2];
    const RoadWheel& wheel = _wheels[index];
    const double other = _wheels[index ^ 1U].travelM;
    double force = _restN[index / 2] + axle.springNPerM * wheel.travelM +
                   axle.antiRollNPerM * (wheel.travelM - other) +
                   (wheel.travelMps > 0.0 ? axle.bumpNsPerM : axle.reboundNsPerM) * wheel.travelMps;
    if (wheel.travelM > axle.bumpM) force += axle.stopNPerM * (wheel.travelM - axle.bumpM);
    if (wheel.travelM < -axle.reboundM) force += axle.stopNPerM * (wheel.travelM + axle.reboundM);
    return force;
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

/// Holds a braked wheel near the slip at which friction peaks: the brake follows what the tyre bears, more below that slip and less
/// above it, as fast as valves let it. Source: Savaresi, Tanelli, *Active Braking Control Systems Design for Vehicles*, 2010, chapter 3
/// (slip control). Differs: it knows the tyre's slip and force.
void RoadVehicle::antiLock(RoadWheel& wheel, double wheelBrakeNm, double rollingMps, double stepS) const
{
    const BrakeData& brakes = _data->brakes;
    if (brakes.absSlip <= 0.0 || rollingMps < brakes.absFromMps || wheelBrakeNm <= 0.0)
    {
        wheel.brakeShare = 1.0;
        return;
    }
    double wanted = 1.0;
    if (wheel.slip < 0.0 && wheel.tyreSlip > kAbsWatches * brakes.absSlip)
        wanted = -wheel.forceN.x * wheel.contactRadiusM / wheelBrakeNm *
                 (1.0 + kAbsGain * (brakes.absSlip - wheel.tyreSlip));
    wheel.brakeShare += std::clamp(wanted - wheel.brakeShare, -kAbsFall * stepS, kAbsRise * stepS);
    wheel.brakeShare = std::clamp(wheel.brakeShare, 0.0, 1.0);
}

/// Turns a wheel by drive and tyre; brakes and rolling resistance hold it as dry friction.
void RoadVehicle::spin(std::size_t index, double driveNm, double rollingMps, double stepS)
{
    const AxleData& axle = _data->axles[index / 2];
    const BrakeData& brakes = _data->brakes;
    RoadWheel& wheel = _wheels[index];
    const double wheelBrakeNm = 0.5 * axle.brakeShare * _brakeNm;
    antiLock(wheel, wheelBrakeNm, rollingMps, stepS);
    const double radius = wheel.contactRadiusM;
    const double resistance = axle.tyre.rollingResistance +
                              frictionOf(wheel.ground.kind()).rollingResistance -
                              frictionOf(GroundKind::asphalt).rollingResistance;
    const double handbrake =
        _status.condition == VehicleCondition::crashed ? 1.0 : inputOf(_inputs, RoadInput::handbrake);
    const double holdsNm = wheelBrakeNm * wheel.brakeShare +
                           0.5 * axle.handbrakeShare * brakes.handbrakeNm * handbrake +
                           std::max(0.0, resistance) * wheel.loadN * radius;
    const double inertia = axle.wheelInertiaKgM2 + 0.5 * axle.driveShare * _drivetrain.reflectedInertia();
    const double turned = wheel.radps + stepS * (driveNm - wheel.forceN.x * radius) / inertia;
    const double held = stepS * holdsNm / inertia;
    wheel.radps = std::abs(turned) <= held ? 0.0 : turned - std::copysign(held, turned);
    wheel.rotationRad = std::remainder(wheel.rotationRad + stepS * wheel.radps, 2.0 * std::numbers::pi);
}

void RoadVehicle::pressWheel(std::size_t index, double driveNm, double stepS)
{
    const AxleData& axle = _data->axles[index / 2];
    const RoadTyreData& tyre = axle.tyre;
    RoadWheel& wheel = _wheels[index];
    const Axes body = axes();
    const glm::dvec3 hub = hubOf(index);
    wheel.contact = {};
    if (wheel.ground.isKnown()) wheel.contact = wheel.ground.contactOf(hub, tyre.radiusM);
    const glm::dvec3 normal = wheel.contact.normal;
    const double upright = glm::dot(normal, body.up);
    const glm::dvec3 arm = wheel.contact.place - _motion.position;
    const glm::dvec3 velocity = _motion.velocity + glm::cross(_motion.rates, arm);
    const double closing = -glm::dot(velocity + wheel.travelMps * body.up, normal);
    wheel.loadN = 0.0;
    if (wheel.contact.depthM > 0.0 && upright > kTyreCosine)
        wheel.loadN = std::clamp(axle.tyresPerSide *
                                     (tyre.springNPerM * wheel.contact.depthM + tyre.dampingNsPerM * closing),
                                 0.0, kMostLoad * std::max(_restN[index / 2], tyre.referenceLoadN));

    glm::dvec3 along = std::cos(wheel.steerRad) * body.forward + std::sin(wheel.steerRad) * body.left;
    along = glm::normalize(along - glm::dot(along, normal) * normal);
    const glm::dvec3 across = glm::cross(normal, along);
    const double rolling = glm::dot(velocity, along);
    wheel.contactRadiusM = tyre.radiusM - std::max(0.0, wheel.contact.depthM) / 3.0;
    const TyreMotion motion{rolling, rolling - wheel.radps * wheel.contactRadiusM,
                            glm::dot(velocity, across)};
    wheel.slip = -motion.slidingAlongMps / std::max(std::abs(rolling), 0.5);
    const double count = axle.tyresPerSide;
    const TyreForce pulls = tyreForce(tyre, wheel.loadN / count, frictionOf(wheel.ground.kind()).gripFactor,
                                      motion, stepS, wheel.bend);
    wheel.forceN = count * pulls.forceN;
    wheel.tyreSlip = pulls.slip;
    spin(index, driveNm, rolling, stepS);

    const glm::dvec3 force = wheel.loadN * normal + wheel.forceN.x * along + wheel.forceN.y * across;
    const double upwards = glm::dot(force, body.up);
    const double aside = (isLeft(index) ? 0.5 : -0.5) * axle.trackM;
    // What the links carry upwards, so that the forces of both wheels meet in the roll centre.
    const double jacking = -glm::dot(force, body.left) * axle.rollCentreM / aside;
    const double spring = springForce(index);
    _world->push(_body, force + (spring + jacking - upwards) * body.up,
                 wheel.loadN > 0.0 ? arm : hub - _motion.position);
    wheel.travelMps += stepS * (upwards - spring - jacking) / axle.unsprungKg;
    wheel.travelM += stepS * wheel.travelMps;
    const double most = axle.bumpM + 0.1, least = -axle.reboundM - 0.1;
    if (wheel.travelM > most || wheel.travelM < least)
    {
        wheel.travelM = std::clamp(wheel.travelM, least, most);
        wheel.travelMps = 0.0;
    }
}

/// Forces of one short step.
void RoadVehicle::press(double stepS)
{
    if (_status.condition == VehicleCondition::failed) return;
    const double pedal =
        _status.condition == VehicleCondition::crashed ? 0.3 : inputOf(_inputs, RoadInput::brake);
    _brakeNm += (pedal * _data->brakes.mostNm - _brakeNm) * stepS / (_data->brakes.lagS + stepS);
    if (_brakeNm < 1.0 && pedal == 0.0) _brakeNm = 0.0;
    double drivenInertia = 0.0;
    for (const AxleData& axle : _data->axles)
        if (axle.driveShare > 0.0) drivenInertia += 2.0 * axle.wheelInertiaKgM2;
    const double driveNm = _drivetrain.drive(_inputs, shaftRadps(), drivenInertia, stepS);
    for (std::size_t i = 0; i < 4; ++i)
        pressWheel(i, 0.5 * _data->axles[i / 2].driveShare * driveNm, stepS);
    _world->push(_body, _airForce, glm::dvec3(0.0));
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
    if (hit.closingMps > _data->hull.crashesAtMps) crash("it hit something hard");
    const bool isOver = glm::dot(axes().up, -_gravity) < kOverCosine * glm::length(_gravity);
    _overS = isOver ? _overS + stepS : 0.0;
    if (_overS > kOverTimeS && hit.touches) crash("it rolled over");
    for (const RoadWheel& wheel : _wheels)
        if (wheel.isTouching() && wheel.ground.kind() == GroundKind::water) crash("it drove into water");
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
