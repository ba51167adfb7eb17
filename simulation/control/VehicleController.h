// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "simulation/player/Traffic.h"
#include "simulation/vehicle/DynamicVehicle.h"

namespace simulation
{

/// All that a controller may know before a step.
struct ControlView
{
    const VehicleState& state;
    VehicleStatus status;
    const Ground& ground;
    const Air& air;
    const Traffic& traffic;
    std::int64_t step = 0; ///< steps made since the vehicle's start
    double timeS = 0.0;    ///< of the simulation
};

/// Whatever controls a vehicle: recorded inputs, an autopilot, a driver, a person. It has its route and its
/// orders from its maker.
/// Determinism: the inputs depend on the views so far alone. Threads: one.
class VehicleController
{
public:
    virtual ~VehicleController() = default;

    /// Writes the inputs of the step that follows. `inputs`: those of the last step, in the order of
    /// DynamicVehicle::inputNames().
    virtual void control(const ControlView& view, std::span<double> inputs) = 0;

    /// Gets the vehicle back after somebody else controlled it; control() follows. `inputs`: as they are.
    virtual void resume(const ControlView& /*view*/, std::span<const double> /*inputs*/) {}

    /// Hears which speed the scenario asks for; it may wish another one later. Units: m/s over the ground or
    /// through still air.
    virtual void askForSpeed(double /*speedMps*/) {}

    /// Hears beside which place of its way the scenario wants it to be; nothing: on its own way again.
    virtual void askForPlace(const std::optional<glm::dvec3>& /*place*/) {}

    /// What it is about, in a word or two, for logs and instruments; empty: nothing to say.
    virtual std::string_view phase() const { return {}; }

    /// What a person should know of what it did, in a sentence without a subject ("turned before a hill");
    /// empty: nothing.
    virtual std::string note() const { return {}; }

    /// Whether it has done all that it was told; it goes on controlling nevertheless.
    virtual bool isDone() const { return false; }
};

} // namespace simulation
