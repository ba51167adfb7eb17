// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulation/control/ControlledVehicle.h"
#include "simulation/player/ExternalMotion.h"

namespace simulation
{

/// Moves an entity as a vehicle and its controller do. The vehicle makes its own steps, whatever times are asked for; between two of them
/// the state is interpolated: equal times have equal vehicle states at any rate of pictures.
class VehicleMotion final : public ExternalMotion
{
public:
    VehicleMotion(std::unique_ptr<ControlledVehicle> vehicle, std::shared_ptr<const Ground> ground,
                  std::shared_ptr<const Air> air);

    foundation::Outcome begin(const EntityState& start, bool isAirborne) override;
    void advanceTo(double timeS, const Traffic& traffic) override;
    const EntityState& state() const override { return _state; }
    bool isDone() const override { return _vehicle->controller() && _vehicle->controller()->isDone(); }

    /// When and why it is not sound any more.
    std::string note() const override { return _note; }

    const ControlledVehicle& vehicle() const { return *_vehicle; }

private:
    void publish(double timeS);

    std::unique_ptr<ControlledVehicle> _vehicle;
    std::shared_ptr<const Ground> _ground;
    std::shared_ptr<const Air> _air;
    EntityState _state;
    double _odometerM = 0.0;
    std::string _note;
};

/// Place, attitude and speed of a vehicle's reference point, as entities have them. `reference`: of DynamicVehicle.
EntityState entityStateOf(const VehicleState& vehicle, const glm::dvec3& reference);

} // namespace simulation
