// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/Aerodynamics.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <glm/common.hpp>

namespace simulation
{

namespace
{

constexpr double kBlendDeg = 10.0;    ///< beyond the attached range, in which the plate takes over
constexpr double kSideslipDeg = 20.0; ///< up to here the fuselage is no plate

/// The coefficients at one state of flow.
class Coefficients
{
public:
    Coefficients(const AircraftData& aircraft, const AirData& air, const SurfaceAngles& surfaces,
                 const FlowState& flow)
        : _aircraft(aircraft)
    {
        set(Argument::alphaDeg, foundation::degreesOf(air.alpha));
        set(Argument::betaDeg, foundation::degreesOf(air.beta));
        set(Argument::flapDeg, surfaces.flapDeg);
        set(Argument::stalled, flow.stalled);
        set(Argument::heightOverSpan, flow.heightOverSpan);
    }

    double operator()(Part part) const
    {
        const CoefficientTable& coefficient = _aircraft.coefficient(part);
        return coefficient.table.at(get(coefficient.row), get(coefficient.column));
    }

    double get(Argument argument) const { return _values[static_cast<std::size_t>(argument)]; }

private:
    void set(Argument argument, double value) { _values[static_cast<std::size_t>(argument)] = value; }

    const AircraftData& _aircraft;
    std::array<double, static_cast<std::size_t>(Argument::count)> _values{};
};

/// Rates without dimension.
struct ReducedRates
{
    double roll = 0.0, pitch = 0.0, yaw = 0.0, alpha = 0.0;
};

ReducedRates reducedRates(const AircraftData& aircraft, const AirData& air)
{
    const double twice = 2.0 * std::max(air.speedMps, 1.0);
    return {air.rates.x * aircraft.wingSpanM / twice, air.rates.y * aircraft.meanChordM / twice,
            air.rates.z * aircraft.wingSpanM / twice, air.alphaRate * aircraft.meanChordM / twice};
}

/// How much of the flow is a plate's, for an angle and its range: 0 inside, 1 well outside.
double plateShare(double degrees, double leastDeg, double mostDeg)
{
    const double outside = std::max(leastDeg - degrees, degrees - mostDeg);
    return glm::smoothstep(0.0, kBlendDeg, outside);
}

double plateShareOfAlpha(const AircraftData& aircraft, double alphaDeg)
{
    const Table& lift = aircraft.coefficient(Part::lift).table;
    return plateShare(alphaDeg, lift.firstRow(), lift.lastRow());
}

double mix(double attached, double plate, double share)
{
    return attached + share * (plate - attached);
}

/// Lift, drag and side force over dynamic pressure and wing area, as (-drag, side, -lift).
glm::dvec3 forceCoefficients(const AircraftData& aircraft, const Coefficients& c, const AirData& air,
                             const SurfaceAngles& surfaces, const ReducedRates& rates)
{
    const double plate = plateShareOfAlpha(aircraft, c.get(Argument::alphaDeg));
    const double across = aircraft.stall.plateSide * std::sin(air.beta) *
                          plateShare(c.get(Argument::betaDeg), -kSideslipDeg, kSideslipDeg);
    const double sinAlpha = std::sin(air.alpha), cosAlpha = std::cos(air.alpha);
    const double sinBeta = std::sin(air.beta), cosBeta = std::cos(air.beta);
    const double normal = aircraft.stall.plateNormal * sinAlpha * cosBeta;
    const double lift =
        mix(c(Part::liftGround) * (c(Part::lift) + c(Part::liftFlap)), normal * cosAlpha, plate) +
        c(Part::liftElevator) * surfaces.elevator + c(Part::liftAlphaRate) * rates.alpha +
        c(Part::liftPitchRate) * rates.pitch;
    const double drag = c(Part::drag) + across * sinBeta +
                        mix(c(Part::dragGround) * (c(Part::dragAlpha) + c(Part::dragFlap)),
                            std::abs(normal * sinAlpha), plate) +
                        c(Part::dragElevator) * std::abs(surfaces.elevator) +
                        c(Part::dragSideslip) * std::abs(air.beta);
    const double side = c(Part::side) - across * cosBeta + c(Part::sideAileron) * surfaces.aileron +
                        c(Part::sideRudder) * surfaces.rudder + c(Part::sideRollRate) * rates.roll +
                        c(Part::sideYawRate) * rates.yaw;
    return {-drag, side, -lift};
}

/// Rolling, pitching and yawing moment; the rudder and the elevator work in the slipstream.
glm::dvec3 momentCoefficients(const AircraftData& aircraft, const Coefficients& c, const AirData& air,
                              const SurfaceAngles& surfaces, const ReducedRates& rates, double slipstream)
{
    const Table& lift = aircraft.coefficient(Part::lift).table;
    const double alphaDeg = c.get(Argument::alphaDeg);
    const double inside = foundation::radiansOf(std::clamp(alphaDeg, lift.firstRow(), lift.lastRow()));
    const double attached = c(Part::pitch) + c(Part::pitchFlap) + c(Part::pitchAlpha) * inside;
    const double pitch = mix(attached, -aircraft.stall.platePitch * std::sin(air.alpha),
                             plateShareOfAlpha(aircraft, alphaDeg)) +
                         slipstream * c(Part::pitchElevator) * surfaces.elevator +
                         c(Part::pitchAlphaRate) * rates.alpha + c(Part::pitchPitchRate) * rates.pitch;
    const double roll = c(Part::roll) + c(Part::rollAileron) * surfaces.aileron +
                        c(Part::rollRudder) * surfaces.rudder + c(Part::rollRollRate) * rates.roll +
                        c(Part::rollYawRate) * rates.yaw;
    const double yaw = c(Part::yaw) + c(Part::yawAileron) * surfaces.aileron +
                       slipstream * c(Part::yawRudder) * surfaces.rudder + c(Part::yawRollRate) * rates.roll +
                       c(Part::yawYawRate) * rates.yaw;
    return {roll, pitch, yaw};
}

/// Turns a force from the axes of the wind into those of the body.
glm::dvec3 bodyFromWind(const glm::dvec3& force, const AirData& air)
{
    const double sinAlpha = std::sin(air.alpha), cosAlpha = std::cos(air.alpha);
    const double sinBeta = std::sin(air.beta), cosBeta = std::cos(air.beta);
    const double forward = force.x * cosBeta - force.y * sinBeta;
    return {forward * cosAlpha - force.z * sinAlpha, force.x * sinBeta + force.y * cosBeta,
            forward * sinAlpha + force.z * cosAlpha};
}

} // namespace

ForceMoment aerodynamicForces(const AircraftData& aircraft, const AirData& air, const SurfaceAngles& surfaces,
                              const FlowState& flow, const glm::dvec3& arm)
{
    const Coefficients coefficients(aircraft, air, surfaces, flow);
    const ReducedRates rates = reducedRates(aircraft, air);
    const double pressure = air.dynamicPressurePa;
    const double slipstream = flow.slipstreamPressurePa / std::max(pressure, 1.0);
    const double scale = pressure * aircraft.wingAreaM2;
    const glm::dvec3 lengths(aircraft.wingSpanM, aircraft.meanChordM, aircraft.wingSpanM);
    ForceMoment result;
    result.force = bodyFromWind(scale * forceCoefficients(aircraft, coefficients, air, surfaces, rates), air);
    result.moment =
        scale * lengths * momentCoefficients(aircraft, coefficients, air, surfaces, rates, slipstream) +
        glm::cross(arm, result.force);
    return result;
}

} // namespace simulation
