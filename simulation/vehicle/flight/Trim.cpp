// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/Trim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include <foundation/Angle.h>
#include <foundation/Earth.h>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{

namespace
{

constexpr std::size_t kUnknowns = 7;
constexpr int kMostRounds = 60;
using Vector = std::array<double, kUnknowns>;
using Matrix = std::array<Vector, kUnknowns>;

/// The unknowns. Radians, commands, and the engine's speed over 100 rad/s.
enum Unknown
{
    kAlpha,
    kElevator,
    kPower, ///< throttle, or climb angle where the throttle is given
    kAileron,
    kRudder,
    kSide, ///< bank where the flight is straight, sideslip in a turn
    kEngineSpeed
};

/// Solves a linear system by elimination with the largest pivot; a singular one gives no numbers.
Vector solved(Matrix matrix, Vector right)
{
    for (std::size_t i = 0; i < kUnknowns; ++i)
    {
        std::size_t pivot = i;
        for (std::size_t row = i + 1; row < kUnknowns; ++row)
            if (std::abs(matrix[row][i]) > std::abs(matrix[pivot][i])) pivot = row;
        std::swap(matrix[i], matrix[pivot]);
        std::swap(right[i], right[pivot]);
        for (std::size_t row = 0; row < kUnknowns; ++row)
        {
            if (row == i) continue;
            const double factor = matrix[row][i] / matrix[i][i];
            for (std::size_t column = i; column < kUnknowns; ++column)
                matrix[row][column] -= factor * matrix[i][column];
            right[row] -= factor * right[i];
        }
    }
    for (std::size_t i = 0; i < kUnknowns; ++i)
        right[i] /= matrix[i][i];
    return right;
}

/// One search for a steady flight.
class Search
{
public:
    Search(const AircraftData& aircraft, const EarthFrame& earth, const AirSample& air,
           const TrimTarget& target)
        : _aircraft(aircraft),
          _earth(earth),
          _target(target),
          _place(earth.placeAt(target.position)),
          _gravity(earth.gravityAt(target.position))
    {
        _surroundings.air = air;
        _surroundings.earthRate = earth.earthRate();
        for (std::size_t i = 0; i < aircraft.tanks.size() && i < kMostTanks; ++i)
            _fuelKg[i] = aircraft.tanks[i].contentsKg;
        _mass = massProperties(aircraft, _fuelKg);
    }

    bool isTurn() const { return _target.bankDeg != 0.0; }
    double pathOf(const Vector& x) const
    {
        return _target.throttle ? x[kPower] : foundation::radiansOf(_target.pathDeg);
    }
    double throttleOf(const Vector& x) const { return _target.throttle.value_or(x[kPower]); }

    TrimmedFlight flightOf(const Vector& x) const;
    Vector residualOf(const Vector& x) const;
    foundation::Result<Vector> run() const;

private:
    glm::dvec3 turningOf(const glm::dvec3& velocity, double roll) const;

    const AircraftData& _aircraft;
    const EarthFrame& _earth;
    const TrimTarget& _target;
    EarthFrame::Place _place;
    glm::dvec3 _gravity;
    FlightSurroundings _surroundings;
    std::array<double, kMostTanks> _fuelKg{};
    MassProperties _mass;
};

/// The turning of a steady flight in the scene: about up in a turn, and over the round Earth.
glm::dvec3 Search::turningOf(const glm::dvec3& velocity, double roll) const
{
    const glm::dvec3 over = glm::cross(_place.up, velocity) / foundation::kEarthRadiusM;
    if (!isTurn()) return over;
    const double flat = glm::length(velocity - glm::dot(velocity, _place.up) * _place.up);
    return over - _place.up * (foundation::kStandardGravityMps2 * std::tan(roll) / std::max(flat, 1.0));
}

TrimmedFlight Search::flightOf(const Vector& x) const
{
    const double path = pathOf(x), speed = _target.trueAirspeedMps;
    const double roll = isTurn() ? foundation::radiansOf(_target.bankDeg) : x[kSide];
    const double beta = isTurn() ? x[kSide] : 0.0;
    // Pitch from the climb angle: the velocity, in body axes, has the slope sin(path).
    const glm::dvec3 inBody = speed * glm::dvec3(std::cos(x[kAlpha]) * std::cos(beta), std::sin(beta),
                                                 std::sin(x[kAlpha]) * std::cos(beta));
    const double along = inBody.x / speed;
    const double below = (std::sin(roll) * inBody.y + std::cos(roll) * inBody.z) / speed;
    const double size = std::hypot(along, below);
    const double pitch = std::asin(std::clamp(std::sin(path) / size, -1.0, 1.0)) + std::atan2(below, along);

    TrimmedFlight flight;
    FlightState& state = flight.state;
    BodyMotion& motion = state.motion;
    motion.position = _target.position;
    motion.attitude = levelAttitude(_place, foundation::radiansOf(_target.headingDeg), pitch, roll);
    const glm::dvec3 through = motion.attitude * inBody;
    motion.velocity = through + _surroundings.air.windMps;
    motion.rates = glm::conjugate(motion.attitude) * (turningOf(through, roll) + _earth.earthRate());
    state.engineRadps = 100.0 * x[kEngineSpeed];
    state.flapDeg = _target.flapDeg;
    state.fuelKg = _fuelKg;
    state.manifoldPa =
        steadyManifoldPa(_aircraft.engine, throttleOf(x), state.engineRadps, _surroundings.air.pressurePa);
    const auto input = [&](FlightInput which) -> double&
    { return flight.inputs[static_cast<std::size_t>(which)]; };
    input(FlightInput::elevatorTrim) = x[kElevator];
    input(FlightInput::aileron) = x[kAileron];
    input(FlightInput::rudder) = x[kRudder];
    input(FlightInput::throttle) = throttleOf(x);
    input(FlightInput::mixture) = _target.mixture;
    input(FlightInput::flaps) =
        _aircraft.flaps.fullDeg > 0.0 ? _target.flapDeg / _aircraft.flaps.fullDeg : 0.0;
    flight.pathDeg = foundation::degreesOf(path);
    return flight;
}

/// How fast the flight changes: the velocity against its own turning, the rates, and the engine.
Vector Search::residualOf(const Vector& x) const
{
    const TrimmedFlight flight = flightOf(x);
    const BodyMotion& motion = flight.state.motion;
    const FlightLoads loads = flightLoads(_aircraft, _mass, flight.state, flight.inputs, _surroundings);
    const double spin = _aircraft.propeller.spin(flight.state.engineRadps);
    const BodySurroundings around{_gravity, _surroundings.earthRate, spin};
    const glm::dquat toBody = glm::conjugate(motion.attitude);
    const glm::dvec3 turning = motion.attitude * motion.rates - _earth.earthRate();
    const glm::dvec3 change = toBody * (accelerationOf(motion, _mass, loads.load.force, around) -
                                        glm::cross(turning, motion.velocity - _surroundings.air.windMps));
    const glm::dvec3 turn = angularAccelerationOf(motion.rates, _mass, loads.load.moment, spin);
    return {change.x,
            change.y,
            change.z,
            turn.x,
            turn.y,
            turn.z,
            0.1 * (loads.engine.torqueNm - loads.propeller.torqueNm) / _aircraft.propeller.inertiaKgM2};
}

double sizeOf(const Vector& vector)
{
    double sum = 0.0;
    for (const double value : vector)
        sum += value * value;
    return std::sqrt(sum);
}

foundation::Result<Vector> Search::run() const
{
    Vector x{0.05, 0.0, _target.throttle ? 0.0 : 0.6, 0.0, 0.0, 0.0, 2.3};
    Vector residual = residualOf(x);
    for (int round = 0; round < kMostRounds && sizeOf(residual) > 1e-10; ++round)
    {
        Matrix slope{};
        for (std::size_t column = 0; column < kUnknowns; ++column)
        {
            constexpr double kNudge = 1e-6;
            Vector nudged = x;
            nudged[column] += kNudge;
            const Vector changed = residualOf(nudged);
            for (std::size_t row = 0; row < kUnknowns; ++row)
                slope[row][column] = (changed[row] - residual[row]) / kNudge;
        }
        const Vector full = solved(slope, residual);
        bool isBetter = false;
        for (double share = 1.0; share > 1e-3 && !isBetter; share *= 0.5)
        {
            Vector next = x;
            for (std::size_t i = 0; i < kUnknowns; ++i)
                next[i] -= share * std::clamp(full[i], -0.3, 0.3);
            next[kEngineSpeed] = std::clamp(next[kEngineSpeed], 0.5, 4.0);
            const Vector changed = residualOf(next);
            isBetter = sizeOf(changed) < sizeOf(residual);
            if (isBetter) x = next, residual = changed;
        }
        if (!isBetter) break;
    }
    if (!(sizeOf(residual) < 1e-6))
        return foundation::Error{"trim",
                                 "no steady flight was found at " +
                                     std::to_string(std::lround(_target.trueAirspeedMps)) + " m/s",
                                 "choose a speed between stall and the fastest level flight"};
    return x;
}

/// The error that tells that an engine is too weak for a climb angle, by the path on which it is not; nothing
/// where there is none within 12 degrees.
std::optional<foundation::Error> lackOfPower(const AircraftData& aircraft, const EarthFrame& earth,
                                             const AirSample& air, TrimTarget target)
{
    constexpr int kMostDeg = 12;
    if (target.throttle) return {};
    const double wantedDeg = target.pathDeg;
    for (int deg = 1; deg <= kMostDeg; ++deg)
    {
        target.pathDeg = wantedDeg - deg;
        const Search search(aircraft, earth, air, target);
        const foundation::Result<Vector> found = search.run();
        if (!found || search.throttleOf(*found) > 1.0) continue;
        char what[160];
        std::snprintf(
            what, sizeof what,
            "power lacks for steady flight at %.0f m/s: the aircraft keeps this speed only on a path "
            "that is %d° lower",
            target.trueAirspeedMps, deg);
        return foundation::Error{"trim", what, "choose a lower height, or another speed"};
    }
    // Higher up a rich mixture burns no more. Where the same flight is steady in the air of the sea, height
    // is at fault.
    target.pathDeg = wantedDeg;
    if (!Search(aircraft, earth, AirSample{}, target).run()) return {};
    return foundation::Error{"trim",
                             "power lacks for steady flight at " +
                                 std::to_string(std::lround(target.trueAirspeedMps)) +
                                 " m/s in the thin air of this height",
                             "choose a lower height, or another speed"};
}

} // namespace

foundation::Result<TrimmedFlight> trim(const AircraftData& aircraft, const EarthFrame& earth,
                                       const AirSample& air, const TrimTarget& target)
{
    if (!(target.trueAirspeedMps > 1.0) || !(std::abs(target.bankDeg) < 80.0))
        return foundation::Error{"trim", "is asked for a speed or a bank that no steady flight has",
                                 "give more than 1 m/s and less than 80°"};
    const Search search(aircraft, earth, air, target);
    const foundation::Result<Vector> found = search.run();
    if (!found || search.throttleOf(*found) > 1.0)
        if (const auto weak = lackOfPower(aircraft, earth, air, target)) return *weak;
    if (!found) return found.error();
    const auto beyond = [](const char* what)
    {
        return foundation::Error{"trim",
                                 std::string("the steady flight needs more ") + what + " than there is",
                                 "choose another speed, climb, bank or load"};
    };
    const Vector& x = *found;
    if (search.throttleOf(x) < 0.0 || search.throttleOf(x) > 1.0) return beyond("throttle");
    if (std::abs(x[kElevator]) > 1.0) return beyond("elevator");
    if (std::abs(x[kAileron]) > 1.0) return beyond("aileron");
    if (std::abs(x[kRudder]) > 1.0) return beyond("rudder");
    return search.flightOf(x);
}

} // namespace simulation
