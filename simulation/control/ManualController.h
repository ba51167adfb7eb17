// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include "simulation/control/VehicleController.h"

namespace simulation
{

/// How one input is moved by hand. Units: those of the input, seconds.
struct InputAxis
{
    std::string_view input; ///< its name
    double least = -1.0, most = 1.0;
    double perSecond = 1.0;       ///< while a key is held
    double returnPerSecond = 0.0; ///< towards `rest` while none is; 0: it stays
    double rest = 0.0;

    /// How far held keys reach at a speed in m/s: (softMps / speed)² + softLeast of the range, 1 at most, so
    /// that a bend's lateral acceleration stays the same. softMps 0: they reach all.
    double softMps = 0.0, softLeast = 0.0;

    /// Where it begins under manual control from the first step on; absent: where it is.
    std::optional<double> start{};

    /// What the vehicle gets of it while it is parked (ManualController::parkUntil()); absent: the axis.
    std::optional<double> parked{};
};

/// Controls a vehicle as a person does: keys that are held move an input step by step, devices put it where
/// they are.
/// Determinism: the inputs depend on the calls between steps alone, not on when pictures are drawn. Threads:
/// one.
class ManualController final : public VehicleController
{
public:
    /// Errors: an axis of an input that the vehicle has not.
    static foundation::Result<ManualController> create(std::vector<InputAxis> axes,
                                                       const DynamicVehicle& vehicle);

    /// Takes over: every input goes on from where it is. `isStart`: at the first step of all; what was put
    /// before it stays.
    void takeOver(std::span<const double> inputs, bool isStart = false);

    /// The vehicle is parked from the first step of all, where it begins at a standstill, until this axis is
    /// moved away from its rest: axes that have a `parked` value give that one, whatever keys and devices do
    /// with them meanwhile. Whoever takes over later has no parked vehicle.
    void parkUntil(std::size_t axis) { _releases = axis; }
    bool isParked() const { return _isParked; }

    /// A key is held that moves the axis up (1) or down (-1), or none is (0).
    void hold(std::size_t axis, double direction);

    /// Puts an axis where a device is; it stays there until a key moves it. Numbers outside its range count
    /// as the nearest in it.
    void put(std::size_t axis, double value);

    /// Moves an axis by an amount, within its range.
    void add(std::size_t axis, double amount);

    /// What else happens at each step of manual control, after the inputs are written: a clutch.
    using Finish = std::function<void(std::span<double> inputs)>;
    void finishBy(Finish finish) { _finish = std::move(finish); }

    void control(const ControlView& view, std::span<double> inputs) override;
    std::string_view phase() const override { return _isParked ? "parked" : "hand"; }

    /// The axis of an input; -1: there is none.
    int axisOf(std::string_view input) const;
    double value(std::size_t axis) const { return _states[axis].value; }
    std::span<const InputAxis> axes() const { return _axes; }

private:
    struct AxisState
    {
        std::size_t place = 0; ///< in the vehicle's inputs
        double value = 0.0, direction = 0.0;
        bool isPut = false; ///< a device holds it
    };

    explicit ManualController(std::vector<InputAxis> axes) : _axes(std::move(axes)), _states(_axes.size()) {}
    void move(const InputAxis& axis, AxisState& state, double speedMps, double stepS) const;

    void park(std::span<double> inputs);

    std::vector<InputAxis> _axes;
    std::vector<AxisState> _states;
    std::optional<std::size_t> _releases; ///< the axis that ends parking
    bool _isParked = false;
    double _stepS = 0.0;
    Finish _finish;
};

} // namespace simulation
