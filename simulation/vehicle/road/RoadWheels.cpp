// SPDX-License-Identifier: Apache-2.0
// The wheels of a road vehicle: springs, brakes with ABS, tyre forces.
#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/Roughness.h"
#include "simulation/vehicle/road/Tyre.h"

namespace simulation
{

namespace
{

constexpr double kMostLoad = 15.0; ///< over the load at rest
constexpr double kTyreCosine =
    0.2; ///< of the angle between wheel and ground, below which a tyre carries nothing
constexpr double kAbsWatches = 0.6;                ///< of its slip, from where on it holds
constexpr double kAbsGain = 1.0;                   ///< of the tyre's torque, over the slip
constexpr double kAbsFall = 25.0, kAbsRise = 10.0; ///< of the share of the brakes, in a second

bool isLeftWheel(std::size_t wheel)
{
    return wheel % 2 == 0;
}

} // namespace

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

/// Holds a braked wheel near the slip at which friction peaks: the brake follows what the tyre bears, more
/// below that slip and less above it, as fast as valves let it. Source: Savaresi, Tanelli, *Active Braking
/// Control Systems Design for Vehicles*, 2010, chapter 3 (slip control). Differs: it knows the tyre's slip
/// and force.
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
    wheel.rotationRad = foundation::wrappedRad(wheel.rotationRad + stepS * wheel.radps);
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
    const TyreForce pulls =
        tyreForce(tyre, wheel.loadN / count, wheel.ground.grip(), motion, stepS, wheel.bend);
    wheel.forceN = count * pulls.forceN;
    wheel.tyreSlip = pulls.slip;
    spin(index, driveNm, rolling, stepS);

    const glm::dvec3 force = wheel.loadN * normal + wheel.forceN.x * along + wheel.forceN.y * across;
    const double upwards = glm::dot(force, body.up);
    const double aside = (isLeftWheel(index) ? 0.5 : -0.5) * axle.trackM;
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
    swim(stepS);
}

} // namespace simulation
