// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/Aircraft.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{

namespace
{

constexpr int kGroundSubsteps = 8;
constexpr double kFastestMps = 400.0;
constexpr double kFastestRadps = 15.0; ///< of tumbling wreckage; faster turning is cut
constexpr double kFarthestM = 2e7;     ///< from the scene's origin
constexpr double kStallTimeS = 0.3;    ///< in which the flow separates or attaches
constexpr double kLargestMps2 = 500.0; ///< of a step's loads, beyond any structure

bool isFinite(const glm::dvec3& vector)
{
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

/// The air on what a crash has left: it drags, and carries no more.
ForceMoment wreckLoad(const AircraftData& aircraft, const MassProperties& mass, const AirData& air)
{
    constexpr double kDrag = 0.5;         // over the wing's area
    constexpr double kTurningTimeS = 1.0; // in which the air ends its tumbling
    const double scale = 0.5 * air.densityKgPerM3 * air.speedMps * aircraft.wingAreaM2;
    return {-kDrag * scale * air.velocity, -(mass.inertia * air.rates) / kTurningTimeS};
}

} // namespace

Aircraft::Aircraft(std::shared_ptr<const AircraftData> data, std::shared_ptr<const EarthFrame> earth,
                   std::uint64_t seed)
    : _data(std::move(data)),
      _earth(std::move(earth)),
      _contacts(*_data),
      _hull(_data),
      _turns(*_data),
      _turbulence(seed)
{
    for (std::size_t i = 0; i < _data->tanks.size() && i < kMostTanks; ++i)
        _state.fuelKg[i] = _data->tanks[i].contentsKg;
    enterStillAir();
}

void Aircraft::place(const FlightState& state, double timeS)
{
    const FlightState before = _state;
    _state = state;
    _step = 0;
    _startS = _timeS = timeS;
    _status = {};
    _hasLastLoad = false;
    _isOnGround = _isAtRest = false;
    _stillS = 0.0;
    _damage = {};
    _contacts.mend();
    _hull.forget();
    if (!isComputable())
    {
        _state = before;
        _status = {VehicleCondition::failed, "it was placed in a state that cannot be computed"};
    }
    enterStillAir();
}

/// Until the first step tells the air, the standard one holds.
void Aircraft::enterStillAir()
{
    _place = _earth->placeAt(_state.motion.position);
    const AirState still = standardAtmosphere(_place.geodetic.heightM);
    _surroundings = {};
    _surroundings.air = {still.densityKgPerM3, still.pressurePa, still.temperatureK, glm::dvec3(0.0)};
    _surroundings.earthRate = _earth->earthRate();
    _heightAboveGroundM = _place.geodetic.heightM;
}

bool Aircraft::isComputable() const
{
    const BodyMotion& motion = _state.motion;
    const glm::dquat& q = motion.attitude;
    const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    return isFinite(motion.position) && isFinite(motion.velocity) && isFinite(motion.rates) &&
           std::abs(square - 1.0) < 1e-3 && glm::length(motion.velocity) < kFastestMps &&
           glm::length(motion.position) < kFarthestM && std::isfinite(_state.engineRadps) &&
           std::isfinite(_state.manifoldPa);
}

FlightSurroundings Aircraft::surroundingsNow(const Ground& ground, const Air& air)
{
    const BodyMotion& motion = _state.motion;
    _place = _earth->placeAt(motion.position);
    ground.below({&motion.position, 1}, {&_below, 1});
    _heightAboveGroundM = _below.isKnown ? motion.position.z - _below.heightM : _place.geodetic.heightM;
    FlightSurroundings surroundings;
    surroundings.air = air.at(motion.position, _place.geodetic.heightM, _timeS);
    surroundings.earthRate = _earth->earthRate();
    const glm::dvec3 wing = motion.attitude * bodyPlace(_data->aerodynamicPoint, _data->empty.place);
    surroundings.heightOverSpan = std::max(0.0, _heightAboveGroundM + wing.z) / _data->wingSpanM;
    if (surroundings.air.windAtSixMetresMps > 0.0 || surroundings.air.gustDeviationMps > 0.0)
    {
        _turbulence.step({glm::length(motion.velocity - surroundings.air.windMps), _heightAboveGroundM,
                          surroundings.air.windAtSixMetresMps, surroundings.air.gustDeviationMps,
                          _data->wingSpanM},
                         kStepS);
        surroundings.gust = _turbulence.velocity();
        surroundings.gustRates = _turbulence.rates();
    }
    return surroundings;
}

void Aircraft::stepSystems(const FlightLoads& loads, const FlightSurroundings& surroundings)
{
    const EngineData& engine = _data->engine;
    const double throttle = inputOf(_inputs, FlightInput::throttle);
    const double steady = steadyManifoldPa(engine, throttle, _state.engineRadps, surroundings.air.pressurePa);
    _state.manifoldPa += (1.0 - std::exp(-kStepS / engine.manifoldLagS)) * (steady - _state.manifoldPa);
    if (_status.condition == VehicleCondition::sound && !_damage.isPropellerBroken)
        _state.engineRadps =
            std::max(0.0, _state.engineRadps + kStepS * (loads.engine.torqueNm - loads.propeller.torqueNm) /
                                                   _data->propeller.inertiaKgM2);
    const double flap = inputOf(_inputs, FlightInput::flaps) * _data->flaps.fullDeg;
    const double most = _data->flaps.rateDegPerS * kStepS;
    _state.flapDeg += std::clamp(flap - _state.flapDeg, -most, most);
    const double alphaDeg = foundation::degreesOf(loads.air.alpha);
    if (alphaDeg > _data->stall.beginsDeg)
        _state.stalled = std::min(1.0, _state.stalled + kStepS / kStallTimeS);
    else if (alphaDeg < _data->stall.endsDeg)
        _state.stalled = std::max(0.0, _state.stalled - kStepS / kStallTimeS);
    double used = loads.engine.fuelKgPerS * kStepS;
    const auto filled =
        std::count_if(_state.fuelKg.begin(), _state.fuelKg.end(), [](double kg) { return kg > 0.0; });
    if (filled > 0) used /= static_cast<double>(filled);
    for (double& fuelKg : _state.fuelKg)
        fuelKg = std::max(0.0, fuelKg - used);
}

void Aircraft::stepMotion(const MassProperties& mass, const FlightLoads& loads,
                          const FlightSurroundings& surroundings, const Ground& ground)
{
    BodyMotion& motion = _state.motion;
    _velocityBefore = motion.velocity;
    // The loads at the middle of the step, from this one and the last (Adams, Bashforth).
    ForceMoment load = loads.load;
    if (_hasLastLoad)
    {
        load.force += 0.5 * (loads.load.force - _lastLoad.force);
        load.moment += 0.5 * (loads.load.moment - _lastLoad.moment);
    }
    _lastLoad = loads.load;
    _hasLastLoad = true;
    const double most = kLargestMps2 * mass.massKg, length = glm::length(load.force);
    if (length > most) load.force *= most / length;

    const BodySurroundings around{_earth->gravityAt(motion.position), surroundings.earthRate,
                                  _data->propeller.spin(_state.engineRadps)};
    const glm::dquat toBody = glm::conjugate(motion.attitude);
    _state.alphaRate =
        alphaRateOf(loads.air.velocity,
                    toBody * accelerationOf(motion, mass, load.force, around) -
                        glm::cross(motion.rates - toBody * surroundings.earthRate, toBody * motion.velocity));
    _isNearGround = _heightAboveGroundM < kLowM && _contacts.look(motion, mass.centre, ground);
    if (_isNearGround) liftOutOfGround();
    lookAround(mass, ground);
    const int substeps = _isNearGround || _isOnHull || _hull.isNear() ? kGroundSubsteps : 1;
    _isOnGround = false;
    for (int i = 0; i < substeps; ++i)
        stepShort(load, mass, around, ground, kStepS / substeps);
    judgeRest();
}

void Aircraft::stepShort(const ForceMoment& load, const MassProperties& mass, const BodySurroundings& around,
                         const Ground& ground, double stepS)
{
    BodyMotion& motion = _state.motion;
    ForceMoment sum = load;
    if (_isNearGround)
    {
        const GroundControls feet{
            -inputOf(_inputs, FlightInput::rudder), inputOf(_inputs, FlightInput::leftBrake),
            inputOf(_inputs, FlightInput::rightBrake), _status.condition == VehicleCondition::crashed};
        sum += _contacts.press(motion, around.earthRate, feet, stepS);
        judgeContacts();
        if (_status.condition == VehicleCondition::crashed && !_isOnHull) lieOnHull(mass, ground);
    }
    if (_waterM) sum += _hull.swim(motion, mass, around, *_waterM, stepS);
    const BodyMotion before = motion;
    advance(motion, mass, sum, around, stepS);
    if (_isOnHull || _hull.isNear()) meetHull(before, mass, stepS);
    const double turning = glm::length(motion.rates);
    if (turning > kFastestRadps) motion.rates *= kFastestRadps / turning;
}

void Aircraft::step(const Ground& ground, const Air& air)
{
    if (_status.condition == VehicleCondition::failed || _isAtRest)
    {
        _timeS = _startS + static_cast<double>(++_step) * kStepS;
        return;
    }
    const FlightState before = _state;
    _surroundings = surroundingsNow(ground, air);
    const MassProperties mass = massProperties(*_data, _state.fuelKg);
    FlightLoads loads = flightLoads(*_data, mass, _state, _inputs, _surroundings);
    if (_status.condition == VehicleCondition::crashed)
        loads.load = wreckLoad(*_data, mass, loads.air);
    else
        bearDamage(loads.load);
    stepMotion(mass, loads, _surroundings, ground);
    stepSystems(loads, _surroundings);
    _turns.step(*_data, _contacts.contacts(),
                glm::dot(_state.motion.velocity, _state.motion.attitude * glm::dvec3(1.0, 0.0, 0.0)),
                _state.engineRadps, kStepS);
    _timeS = _startS + static_cast<double>(++_step) * kStepS;
    if (isComputable()) return;
    _state = before;
    _state.motion.velocity = _state.motion.rates = glm::dvec3(0.0);
    _status = {VehicleCondition::failed, "its motion cannot be computed any further"};
}

} // namespace simulation
