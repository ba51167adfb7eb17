// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "simulation/control/flight/CircuitPlan.h"
#include "simulation/control/flight/FlightOrders.h"
#include "simulation/control/flight/RunwayFlight.h"
#include "simulation/control/flight/TerrainGuard.h"

namespace simulation
{

/// What an autopilot is told.
struct AutopilotSettings
{
    std::shared_ptr<const EarthFrame> earth;
    std::vector<FlightOrder> orders;
    std::optional<RunwayStrip> runway; ///< of takeoff, circuit and land
    /// Climbs and turns before ground that rises ahead, whatever its orders; refuses to take off and to land
    /// where it is in the way.
    bool avoidsGround = true;
};

/// Flies an aircraft by orders, one after the other (docs/algorithms/autopilot.md). After the last it holds
/// what it has. It sees state, air and ground alone, so it flies any vehicle that has the inputs of an
/// aircraft.
class Autopilot final : public VehicleController
{
public:
    /// Errors: a vehicle without elevator, aileron, rudder or throttle; orders that need a runway, and none.
    static foundation::Result<Autopilot> create(AutopilotSettings settings, const DynamicVehicle& vehicle);

    void control(const ControlView& view, std::span<double> inputs) override;

    /// Takes it for a true airspeed; an order of speed that comes later counts in its place.
    void askForSpeed(double speedMps) override { _askedMps = speedMps; }

    /// Goes on with its order from what is flown now. Heading, altitude and speed that no order names are
    /// held as they are.
    void resume(const ControlView& view, std::span<const double> inputs) override;
    std::string_view phase() const override { return _phase; }
    std::string note() const override { return _note; }
    bool isDone() const override { return _order >= _settings.orders.size(); }

private:
    /// Places of inputs in the vehicle's list; -1: it has none.
    struct Places
    {
        int elevator = -1, aileron = -1, rudder = -1, throttle = -1, flaps = -1, mixture = -1, leftBrake = -1,
            rightBrake = -1, ignition = -1;
    };

    Autopilot(AutopilotSettings settings, const Places& places, double wheelsBelowM, double stepS);
    void holdWhatIs(const FlightSense& sense);
    void takeOrders(const FlightSense& sense, const ControlView& view);
    bool isOrderDone(const FlightOrder& order, const FlightSense& sense, double timeS) const;
    void beginOrder(const FlightOrder& order, const FlightSense& sense, const ControlView& view);
    void beginCircuit(const Ground& ground);
    void beginTakeOff(const Ground& ground);
    void beginLanding(const FlightSense& sense, const Ground& ground);
    bool isFree(double aboveM, const std::string& what);
    FlightCommand fly(const FlightSense& sense);
    FlightCommand holdTargets(const FlightSense& sense);
    FlightCommand flyCircuit(const FlightSense& sense);
    FlightCommand avoid(const FlightSense& sense, double bank);
    void lookAhead(const FlightSense& sense, const ControlView& view);
    bool isNearGround() const;
    void write(const FlightCommand& command, std::span<double> inputs) const;

    AutopilotSettings _settings;
    Places _places;
    double _wheelsBelowM, _stepS;
    std::size_t _order = 0;
    bool _hasBegun = false;
    double _orderStartS = 0.0;
    double _heading = 0.0, _altitudeM = 0.0, _speedMps = 0.0, _climbMps = 3.0;
    std::optional<double> _askedMps; ///< true airspeed
    std::optional<TakeOff> _takeOff;
    std::optional<CircuitPlan> _circuit;
    std::optional<Landing> _landing;
    AttitudeHold _attitude;
    SpeedAndClimb _climb;
    bool _isClimbing = false; ///< by pitch for speed, full power or idle
    FlightCommand _last;
    TerrainGuard _guard;
    bool _isAvoiding = false;
    bool _isRefused = false; ///< the order, because of the ground on its way
    std::string_view _phase = "hold";
    std::string _note;
};

} // namespace simulation
