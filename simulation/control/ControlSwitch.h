// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "simulation/control/ManualController.h"

namespace simulation
{

/// Gives a vehicle to a person or to an automatic (an autopilot, a driver, a recording) in turn. Who has it
/// not is not asked. Taking over begins with the inputs as they are, so nothing jumps; an automatic that gets
/// it back goes on with its orders from where the vehicle is (VehicleController::resume()).
/// Threads: one.
class ControlSwitch final : public VehicleController
{
public:
    /// `automatic` may be null: then the person keeps it.
    ControlSwitch(std::unique_ptr<VehicleController> automatic, ManualController manual, bool isByHand)
        : _automatic(std::move(automatic)),
          _manual(std::move(manual)),
          _isByHand(isByHand || !_automatic),
          _hasChanged(_isByHand)
    {
    }

    /// From the next step on. Returns false where there is nobody to give it to.
    bool giveToPerson(bool isByHand)
    {
        if (!isByHand && !_automatic) return false;
        _hasChanged = _hasChanged || isByHand != _isByHand;
        _isByHand = isByHand;
        return true;
    }

    bool isByHand() const { return _isByHand; }
    bool hasAutomatic() const { return _automatic != nullptr; }
    ManualController& manual() { return _manual; }
    const ManualController& manual() const { return _manual; }
    const VehicleController* automatic() const { return _automatic.get(); }

    /// From now on the automatic is asked while the person has it, and what it would do is kept: a test aid.
    void watchWishes() { _watches = _automatic != nullptr; }

    /// The inputs that the automatic would have written at the last step; empty before the first, or
    /// unwatched.
    std::span<const double> wishes() const { return _wishes; }

    void control(const ControlView& view, std::span<double> inputs) override
    {
        const bool hasChanged = std::exchange(_hasChanged, false);
        if (_isByHand)
        {
            if (_watches)
            {
                _wishes.assign(inputs.begin(), inputs.end());
                _automatic->control(view, _wishes);
            }
            if (hasChanged) _manual.takeOver(inputs, view.step == 0);
            return _manual.control(view, inputs);
        }
        if (hasChanged) _automatic->resume(view, inputs);
        _automatic->control(view, inputs);
    }

    std::string note() const override { return _automatic ? _automatic->note() : std::string(); }
    std::string_view phase() const override { return _isByHand ? _manual.phase() : _automatic->phase(); }

    /// A person decides when a ride by hand is over.
    bool isDone() const override { return !_isByHand && _automatic->isDone(); }

private:
    std::unique_ptr<VehicleController> _automatic;
    ManualController _manual;
    bool _isByHand;
    bool _hasChanged; ///< who has it, since the last step
    bool _watches = false;
    std::vector<double> _wishes;
};

} // namespace simulation
