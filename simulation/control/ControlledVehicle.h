// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "simulation/control/InputRecorder.h"
#include "simulation/control/VehicleController.h"

namespace simulation
{

/// A vehicle and whoever controls it, stepped together: the controller writes the inputs, the recorder notes
/// them, the vehicle moves.
/// Determinism: as its parts. The step's length is the vehicle's, whatever the rate of pictures.
class ControlledVehicle
{
public:
    /// `controller` may be null: the inputs stay as they are.
    ControlledVehicle(std::unique_ptr<DynamicVehicle> vehicle, std::unique_ptr<VehicleController> controller);

    /// Records the inputs from now on.
    void record() { _recorder.emplace(*_vehicle); }

    /// Makes one step.
    void step(const Ground& ground, const Air& air, const Traffic& traffic);

    /// Replaces the controller; null: the inputs stay as they are.
    void setController(std::unique_ptr<VehicleController> controller) { _controller = std::move(controller); }

    DynamicVehicle& vehicle() { return *_vehicle; }
    const DynamicVehicle& vehicle() const { return *_vehicle; }
    const VehicleController* controller() const { return _controller.get(); }
    VehicleController* controller() { return _controller.get(); }
    const InputRecorder* recorder() const { return _recorder ? &*_recorder : nullptr; }

    /// Steps made so far.
    std::int64_t steps() const { return _steps; }

    /// Before and after the last step; equal before the first.
    const VehicleState& before() const { return _before; }
    const VehicleState& now() const { return _now; }

    /// Looks at the vehicle anew after it was placed.
    void look() { _before = _now = _vehicle->state(); }

private:
    std::unique_ptr<DynamicVehicle> _vehicle;
    std::unique_ptr<VehicleController> _controller;
    std::optional<InputRecorder> _recorder;
    std::int64_t _steps = 0;
    VehicleState _before, _now;
};

/// The state between two, at a time between theirs; outside it the nearer one. Positions and velocities go
/// straight, attitudes along the shortest arc.
VehicleState stateBetween(const VehicleState& from, const VehicleState& to, double timeS);

} // namespace simulation
