// SPDX-License-Identifier: Apache-2.0
// Where a road vehicle begins, and what it says of itself.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <foundation/Angle.h>

#include "simulation/vehicle/StandardAtmosphere.h"
#include "simulation/vehicle/StartCheck.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

namespace
{

/// The axes of a body on the ground below its four wheels; nothing where that is not known. `place` becomes
/// the reference point.
std::optional<glm::dmat3> standOn(const RoadVehicleData& vehicle, const Ground& ground, double headingRad,
                                  glm::dvec3& place)
{
    const glm::dvec3 start = place;
    glm::dmat3 body(glm::dvec3(std::cos(headingRad), std::sin(headingRad), 0.0),
                    glm::dvec3(-std::sin(headingRad), std::cos(headingRad), 0.0), glm::dvec3(0.0, 0.0, 1.0));
    for (int round = 0; round < 3; ++round)
    {
        std::array<glm::dvec3, 4> wheels;
        std::array<GroundPoint, 4> answers;
        for (std::size_t i = 0; i < 4; ++i)
        {
            const AxleData& axle = vehicle.axles[i / 2];
            wheels[i] = start + body * glm::dvec3(axle.xM, (i % 2 == 0 ? 0.5 : -0.5) * axle.trackM, 0.0);
        }
        ground.heightsBelow(wheels, answers);
        for (std::size_t i = 0; i < 4; ++i)
        {
            if (!answers[i].isKnown) return std::nullopt;
            wheels[i].z = answers[i].heightM;
        }
        const glm::dvec3 front = 0.5 * (wheels[0] + wheels[1]), rear = 0.5 * (wheels[2] + wheels[3]);
        const glm::dvec3 ahead = glm::normalize(front - rear);
        const glm::dvec3 aside = wheels[0] + wheels[2] - wheels[1] - wheels[3];
        const glm::dvec3 up = glm::normalize(glm::cross(ahead, aside));
        body = glm::dmat3(ahead, glm::cross(up, ahead), up);
        place.z = rear.z;
    }
    return body;
}

} // namespace

void RoadVehicle::place(const RoadStart& start, const Ground& ground, double timeS)
{
    _step = 0;
    _startS = _timeS = timeS;
    _status = {};
    _overS = _steerRad = _brakeNm = 0.0;
    _acceleration = _airForce = glm::dvec3(0.0);
    _wheels = {};
    _meeting.obstacles().forget();
    _waterM.reset();
    _airShare = 1.0;
    _drivetrain.reset();
    _before = SolidMotion{};
    _before.position.z = _mass.centre.z;
    const glm::dvec3 sum = start.position + glm::dvec3(start.headingRad, start.speedMps, 0.0);
    if (!std::isfinite(sum.x + sum.y + sum.z) || std::abs(start.speedMps) > 100.0)
        return fail("it was placed in a state that cannot be computed");
    glm::dvec3 place = start.position;
    const std::optional<glm::dmat3> body = standOn(*_data, ground, start.headingRad, place);
    if (!body) return fail("there is no ground where it starts");
    _motion = {};
    _motion.bodyToScene = glm::normalize(glm::quat_cast(*body));
    _motion.position = place + *body * _mass.centre;
    _motion.velocity = start.speedMps * (*body)[0];
    for (std::size_t i = 0; i < 4; ++i)
        _wheels[i].radps = start.speedMps / _data->axles[i / 2].tyre.radiusM;
    _drivetrain.begin(shaftRadps());
    _world->place(_body, _motion);
    if (!isComputable()) fail("it was placed in a state that cannot be computed");
}

foundation::Outcome RoadVehicle::begin(const VehicleStart& start, const Ground& ground, const Air& /*air*/)
{
    if (start.isInAir) return noStart(start, "is in the air", "let a road vehicle begin on the ground");
    GroundPoint below;
    ground.below({&start.position, 1}, {&below, 1});
    if (const auto free = checkStandingStart(start, below); !free) return free;
    RoadVehicle trial(_data, _earth);
    trial.place({start.position, start.headingRad, start.speedMps}, ground);
    if (trial._status.condition != VehicleCondition::sound)
        return noStart(start, std::string(trial._status.reason),
                       "move it onto ground that carries all wheels");
    _inputs = {};
    place({start.position, start.headingRad, start.speedMps}, ground);
    return foundation::success();
}

/// The lamps that pedal, levers and switch light.
void RoadVehicle::writeLamps(EntityState& entity) const
{
    constexpr double kPressed = 0.02, kFlashS = 0.7; // UN R48: 60 to 120 a minute
    const auto light = [&](const char* name, bool isLit) {
        entity.lamps[name] = {isLit ? LightMode::on : LightMode::off, 0.0, 0.0, 0.0, isLit};
    };
    light("brakeLights", inputOf(_inputs, RoadInput::brake) > kPressed);
    light("reversingLights", _drivetrain.state().gear < 0);
    const double indicator = inputOf(_inputs, RoadInput::indicator);
    const bool isFlash = std::fmod(_timeS, kFlashS) < 0.5 * kFlashS;
    light("indicatorLeft", indicator > 0.5 && isFlash);
    light("indicatorRight", indicator < -0.5 && isFlash);
    const double lights = inputOf(_inputs, RoadInput::lights);
    if (std::abs(lights) > 0.5) light("lowBeam", lights > 0.0);
}

void RoadVehicle::writeParts(EntityState& entity) const
{
    entity.wheelTurnDeg.emplace();
    for (std::size_t i = 0; i < 4; ++i)
    {
        double& turn = (*entity.wheelTurnDeg)[i];
        turn = foundation::degreesOf(_wheels[i].rotationRad);
        if (turn < 0.0) turn += 360.0;
    }
    entity.wheelRotationDeg = entity.wheelTurnDeg->front();
    writeLamps(entity);
    if (!entity.readings) entity.readings.emplace();
    entity.readings->gear = _drivetrain.state().gear;
    entity.steeringDeg = foundation::degreesOf(_steerRad);
    entity.isOnGround = state().isOnGround;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const RoadWheel& wheel = _wheels[i];
        const double hanging = _hubZM[i / 2] + wheel.travelM - _data->axles[i / 2].tyre.radiusM;
        // The drawn wheel is round: its lowest point comes to where the tyre stands.
        const glm::dvec3 inBody =
            glm::conjugate(_motion.bodyToScene) * (wheel.contact.place - _motion.position);
        entity.wheelTravelM[i] = wheel.isTouching() ? inBody.z + _mass.centre.z : hanging;
    }
}

VehicleState RoadVehicle::state() const
{
    const bool stands = std::any_of(_wheels.begin(), _wheels.end(),
                                    [](const RoadWheel& wheel) { return wheel.isTouching(); });
    return {_timeS,
            _motion.position,
            _motion.velocity,
            _motion.bodyToScene,
            glm::conjugate(_motion.bodyToScene) * _motion.rates,
            stands};
}

RoadReadings RoadVehicle::readings() const
{
    const Axes body = axes();
    RoadReadings readings;
    readings.speedMps = glm::dot(_motion.velocity, body.forward);
    readings.accelerationMps2 = _acceleration;
    readings.yawRateRadps = glm::dot(_motion.rates, body.up);
    readings.steeringWheelDeg = foundation::degreesOf(_steerRad) * _data->steering.ratio;
    readings.engineRpm = _drivetrain.state().engineRadps * 30.0 / std::numbers::pi;
    readings.gear = _drivetrain.state().gear;
    return readings;
}

double RoadVehicle::energyJ() const
{
    const glm::dvec3 rates = glm::conjugate(_motion.bodyToScene) * _motion.rates;
    double energy = 0.5 * _mass.massKg * glm::dot(_motion.velocity, _motion.velocity) +
                    0.5 * glm::dot(rates, _mass.inertiaKgM2 * rates) +
                    _mass.massKg * foundation::kStandardGravityMps2 * _motion.position.z;
    for (std::size_t i = 0; i < 4; ++i)
        energy += 0.5 * _data->axles[i / 2].wheelInertiaKgM2 * _wheels[i].radps * _wheels[i].radps;
    return energy;
}

} // namespace simulation
