// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "simulation/contact/MovingObstacle.h"
#include "simulation/control/ControlledVehicle.h"
#include "simulation/player/ExternalMotion.h"
#include "simulation/vehicle/WeatheredGround.h"

namespace simulation
{

/// Moves an entity as a vehicle and its controller do. The vehicle makes its own steps, whatever times are
/// asked for; between two of them the state is interpolated: equal times have equal vehicle states at any
/// rate of pictures.
class VehicleMotion final : public ExternalMotion
{
public:
    VehicleMotion(std::unique_ptr<ControlledVehicle> vehicle, std::shared_ptr<const Ground> ground,
                  std::shared_ptr<const Air> air);

    /// Takes wind, air and road friction from the environment of the scenario, from begin() on.
    /// `originHeightM`: of the scene's origin above the ellipsoid; `turbulenceMps`: deviation of gusts above
    /// 600 m.
    void followWeather(double originHeightM, double turbulenceMps);

    /// From now on it meets the other entities of the scene, too, as bodies that go on as they do; not the
    /// one of this name, which it tows.
    void meetOthers(std::string towed = {})
    {
        _meetsOthers = true;
        _towed = std::move(towed);
    }

    foundation::Outcome begin(const EntityState& start, bool isAirborne, double timeS,
                              const EnvironmentState& environment) override;
    void advanceTo(double timeS, const Traffic& traffic) override;
    void askForSpeed(double speedMps) override;
    void askForPlace(const std::optional<glm::dvec3>& place) override;
    const EntityState& state() const override { return _state; }
    bool isDone() const override { return _vehicle->controller() && _vehicle->controller()->isDone(); }

    /// When and why it is not sound any more, else what its controller tells.
    std::string note() const override;
    std::span<const Impact> impacts() const override { return _vehicle->vehicle().impacts(); }
    double begunS() const override { return _startS; }
    std::span<const int> touched() const override { return _touched; }

    const ControlledVehicle& vehicle() const { return *_vehicle; }

private:
    /// What of an environment moves a vehicle.
    struct Weather
    {
        double originHeightM = 0.0, turbulenceMps = 0.0;
        std::optional<Wind> wind{};
        std::optional<double> temperatureK{}, pressurePa{}, seaPressurePa{};
        GroundWeather ground{};
    };

    void publish(double timeS);
    void lookAtOthers(const Traffic& traffic, double sinceS);
    void takeWeather(const EnvironmentState& environment);

    std::unique_ptr<ControlledVehicle> _vehicle;
    std::shared_ptr<const Ground> _land, _ground; ///< as it is, and as the weather leaves it
    std::shared_ptr<const Air> _air;
    std::optional<Weather> _weather; ///< absent: the air is that of the maker
    double _startS = 0.0;            ///< of the simulation
    bool _isDark = false;            ///< as the environment has it: lamps that a vehicle has shine
    EntityState _state;
    double _odometerM = 0.0;
    std::string _note;
    bool _meetsOthers = false;
    std::string _towed;
    std::vector<MovingObstacle> _others; ///< near it, before a step
    std::vector<int> _touched;
};

/// Place, attitude and speed of a vehicle's reference point, as entities have them. `reference`: of
/// DynamicVehicle.
EntityState entityStateOf(const VehicleState& vehicle, const glm::dvec3& reference);

} // namespace simulation
