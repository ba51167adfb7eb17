// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "simulation/control/VehicleController.h"
#include "simulation/control/driver/DriverPath.h"
#include "simulation/road/StopAtSign.h"
#include "simulation/vehicle/road/HandShift.h"

namespace simulation
{

/// How somebody drives. Units: m/s, m/s², s, m.
struct DriverSettings
{
    double speedMps = 1e9;    ///< wanted, where the way allows it
    double lateralMps2 = 2.5; ///< most, in bends
    double accelerateMps2 = 1.8, brakeMps2 = 2.2;
    double headwayS = 1.5;        ///< to whoever drives ahead
    double gapM = 3.0;            ///< to whoever stands ahead
    double waitS = 1.5;           ///< at a stop sign
    bool overtakes = false;       ///< passes slower vehicles on the left where it is free
    double overtakeOffsetM = 3.5; ///< so far to the left
    bool stopsAtEnd = true;       ///< of the way
};

/// A driver: steers along a way by looking ahead, drives as fast as limit, bends, stops and others allow,
/// shifts gears.
///
/// Steering aims at a point of the way some time ahead and adds what the vehicle's understeer takes. Speed
/// follows the intelligent driver model; a stop is a vehicle that stands there.
/// Source: Coulter, *Implementation of the Pure Pursuit Path Tracking Algorithm*, 1992; Treiber, Hennecke,
/// Helbing, *Congested traffic states in empirical observations and microscopic simulations*, 2000
/// (intelligent driver model).
class Driver final : public VehicleController
{
public:
    /// `vehicle`: the one that is driven; it must outlive this.
    Driver(const RoadVehicle& vehicle, DriverPath path, const DriverSettings& settings = {});

    void control(const ControlView& view, std::span<double> inputs) override;
    void askForSpeed(double speedMps) override { _settings.speedMps = speedMps; }
    void askForPlace(const std::optional<glm::dvec3>& place) override;

    /// Goes on along the way from the nearest place of it.
    void resume(const ControlView& view, std::span<const double> inputs) override;
    std::string_view phase() const override { return _phase; }
    bool isDone() const override { return _isDone; }

    /// Where the vehicle's reference point is beside the way.
    const DriverPath::Beside& beside() const { return _beside; }
    const DriverPath& path() const { return _path; }

    /// The largest distance from the way so far.
    double worstOffsetM() const { return _worstM; }
    DriverSettings& settings() { return _settings; }

private:
    static constexpr double kSeenM = 250.0; ///< ahead of the vehicle
    static constexpr double kReachM = 12.0; ///< along the way, in which it is looked for
    static constexpr double kStandsMps = 0.15;

    /// Somebody ahead, or something to stop at.
    struct Ahead
    {
        double gapM = 1e9;
        double speedMps = 0.0;
    };

    double steering(const VehicleState& state);
    void followWish(double speedMps);
    double indicator() const;
    double wantedSpeed(double speedMps) const;
    Ahead nearestAhead(const ControlView& view, double speedMps);
    void lookAtStops(const ControlView& view, double speedMps, Ahead& ahead);
    Ahead lookAtOthers(const ControlView& view, double offsetM) const;
    void considerOvertaking(const ControlView& view, double speedMps);
    double acceleration(double speedMps, const Ahead& ahead) const;
    void pedals(double wantedMps2, double speedMps, RoadInputs& inputs);

    const RoadVehicle& _vehicle;
    DriverPath _path;
    DriverSettings _settings;
    StopAtSign _signs; ///< by places along the way
    HandShift _hand;
    DriverPath::Beside _beside;
    double _understeer = 0.0, _worstM = 0.0;
    double _offsetM = 0.0, _wantedOffsetM = 0.0; ///< from the way, to the left
    double _referenceMps = 0.0, _held = 0.0;
    double _wishMps, _gentleMps; ///< the speed that is wanted, and on the way down to it
    std::size_t _nextStop = 0;
    bool _hasBegun = false, _isDone = false;
    bool _isLed = false; ///< beside its way, where somebody else wants it
    std::string_view _phase = "drive";
};

} // namespace simulation
