// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "simulation/vehicle/DynamicVehicle.h"
#include "simulation/vehicle/EarthFrame.h"
#include "simulation/vehicle/flight/AircraftData.h"
#include "simulation/vehicle/flight/AircraftHull.h"
#include "simulation/vehicle/flight/DrydenTurbulence.h"
#include "simulation/vehicle/flight/FlightModel.h"
#include "simulation/vehicle/flight/GroundContacts.h"
#include "simulation/vehicle/flight/WheelTurns.h"

namespace simulation
{

/// What a pilot's instruments and a log say. Units as named; angles about the local level.
struct FlightReadings
{
    Geodetic place;
    double headingDeg = 0.0; ///< from north, clockwise, 0…360
    double pitchDeg = 0.0, rollDeg = 0.0;
    double trueAirspeedMps = 0.0, calibratedAirspeedMps = 0.0;
    double climbMps = 0.0;
    double alphaDeg = 0.0, betaDeg = 0.0;
    double loadFactor = 1.0;      ///< across the wing, g
    double sideLoad = 0.0;        ///< to the right, g; without the forces of wheels
    double pressurePa = 101325.0; ///< of the air around
    double heightAboveGroundM = 0.0;
    double engineRpm = 0.0, thrustN = 0.0, manifoldPa = 0.0, fuelKgPerS = 0.0;
    double fuelKg = 0.0, massKg = 0.0;
    double flapDeg = 0.0, stalled = 0.0;
    SurfaceAngles surfaces;
};

/// What broke of an aircraft that may fly on.
struct AircraftDamage
{
    bool isPropellerBroken = false;
    std::array<double, 2> wingLost{}; ///< share of the lift of the left and the right wing
};

/// An aircraft that flies by its data file, at 120 steps a second.
///
/// Forces of air and engine are computed once a step and carried to its middle from the last two; near the
/// ground and near what stands the step is divided for struts, tyres and the hull. Parts bend and break by
/// how fast they touch; a crash leaves a wreck that lies by its hull where it comes to rest. Numbers that
/// leave what can be computed end in VehicleCondition::failed, never in NaN.
/// Cost: see docs/algorithms/flight.md.
class Aircraft : public DynamicVehicle
{
public:
    /// `seed`: of the turbulence. Both `data` and `earth` are shared with whoever else flies them.
    Aircraft(std::shared_ptr<const AircraftData> data, std::shared_ptr<const EarthFrame> earth,
             std::uint64_t seed = 0);

    std::span<const std::string_view> inputNames() const override { return kFlightInputNames; }
    std::span<double> inputs() override { return _inputs; }
    double stepSeconds() const override { return kStepS; }
    void step(const Ground& ground, const Air& air) override;
    foundation::Outcome begin(const VehicleStart& start, const Ground& ground, const Air& air) override;
    glm::dvec3 referencePoint() const override;
    void writeParts(EntityState& entity) const override;
    VehicleState state() const override;
    VehicleStatus status() const override { return _status; }
    void meet(std::shared_ptr<const ObstacleMap> obstacles) override { _hull.meet(std::move(obstacles)); }
    void meetMovers(std::span<const MovingObstacle> movers) override { _hull.meetMovers(movers); }
    std::span<const int> touchedMovers() const override { return _hull.touchedMovers(); }
    std::span<const Impact> impacts() const override { return _hull.impacts(); }
    const AircraftDamage& damage() const { return _damage; }

    /// Puts the aircraft into a state; a state that is not finite is refused, and the status says so.
    void place(const FlightState& state, double timeS = 0.0);

    const FlightState& flightState() const { return _state; }
    const FlightInputs& flightInputs() const { return _inputs; }
    const AircraftData& data() const { return *_data; }
    const EarthFrame& earth() const { return *_earth; }
    FlightReadings readings() const;
    std::span<const Contact> contacts() const { return _contacts.contacts(); }

    /// Kinetic and potential energy over the ellipsoid. Units: J.
    double energyJ() const;

    static constexpr double kStepS = 1.0 / 120.0;
    static constexpr double kLowM = 50.0; ///< above the ground, up to which it is looked at for contacts

private:
    /// Where begin() puts it.
    struct Beginning
    {
        FlightState state;
        FlightInputs inputs;
    };

    foundation::Result<Beginning> flyingState(const VehicleStart& start, const GroundPoint& below,
                                              const Air& air) const;
    foundation::Result<Beginning> standingState(const VehicleStart& start, const GroundPoint& below,
                                                const Ground& ground) const;
    FlightSurroundings surroundingsNow(const Ground& ground, const Air& air);
    void stepSystems(const FlightLoads& loads, const FlightSurroundings& surroundings);
    void stepMotion(const MassProperties& mass, const FlightLoads& loads,
                    const FlightSurroundings& surroundings, const Ground& ground);
    void stepShort(const ForceMoment& load, const MassProperties& mass, const BodySurroundings& around,
                   const Ground& ground, double stepS);
    void judgeContacts();
    void judgePart(std::size_t index, const glm::dvec3& place);
    void liftOutOfGround();
    void lookAround(const MassProperties& mass, const Ground& ground);
    void lieOnHull(const MassProperties& mass, const Ground& ground);
    void meetHull(const BodyMotion& before, const MassProperties& mass, double stepS);
    void judgeRest();
    std::string breakPropeller();
    std::string bendWing(bool isRight);
    void bearDamage(ForceMoment& load) const;
    void noteImpact(std::uint32_t thing, double closingMps, const glm::dvec3& place, std::string damage);
    bool isComputable() const;
    void enterStillAir();
    void crash(std::string_view reason);

    std::shared_ptr<const AircraftData> _data;
    std::shared_ptr<const EarthFrame> _earth;
    FlightInputs _inputs = runningInputs();
    FlightState _state;
    ForceMoment _lastLoad;
    bool _hasLastLoad = false;
    FlightSurroundings _surroundings;
    EarthFrame::Place _place;
    double _heightAboveGroundM = 0.0;
    double _timeS = 0.0;
    std::int64_t _step = 0;
    double _startS = 0.0;
    bool _isOnGround = false;
    bool _isNearGround = false; ///< any point of contact, in this step
    GroundPoint _below;         ///< the centre of mass
    GroundContacts _contacts;
    AircraftHull _hull;
    AircraftDamage _damage;
    glm::dvec3 _velocityBefore{0.0}; ///< this step
    std::optional<double> _waterM;   ///< level of the water around it
    bool _isFilling = false;         ///< with water
    bool _isOnHull = false;          ///< a wreck with the ground laid below it
    double _stillS = 0.0;            ///< how long a wreck has not moved
    double _offS = 0.0;              ///< how long nothing of it has touched
    bool _isAtRest = false;
    WheelTurns _turns;
    DrydenTurbulence _turbulence;
    VehicleStatus _status;
};

} // namespace simulation
