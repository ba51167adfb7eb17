// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "simulation/control/Hands.h"

namespace simulation
{

/// Two who control one vehicle in turn: an autopilot, a driver or a recording, and hands. Whoever has it not
/// is not asked. Taking over begins with the inputs as they are, so nothing jumps; an automatic that gets it
/// back goes on with its orders from where the vehicle is (VehicleController::resume()).
/// Threads: one.
class HandOver final : public VehicleController
{
public:
    /// `automatic` may be null: then the hands keep it.
    HandOver(std::unique_ptr<VehicleController> automatic, Hands hands, bool isByHand)
        : _automatic(std::move(automatic)),
          _hands(std::move(hands)),
          _isByHand(isByHand || !_automatic),
          _hasChanged(_isByHand)
    {
    }

    /// From the next step on. Returns false where there is nobody to give it to.
    bool giveToHands(bool isByHand)
    {
        if (!isByHand && !_automatic) return false;
        _hasChanged = _hasChanged || isByHand != _isByHand;
        _isByHand = isByHand;
        return true;
    }

    bool isByHand() const { return _isByHand; }
    bool hasAutomatic() const { return _automatic != nullptr; }
    Hands& hands() { return _hands; }
    const Hands& hands() const { return _hands; }
    const VehicleController* automatic() const { return _automatic.get(); }

    /// From now on the automatic is asked while the hands have it, and what it would do is kept: a test aid.
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
            if (hasChanged) _hands.take(inputs, view.step == 0);
            return _hands.control(view, inputs);
        }
        if (hasChanged) _automatic->resume(view, inputs);
        _automatic->control(view, inputs);
    }

    std::string note() const override { return _automatic ? _automatic->note() : std::string(); }
    std::string_view phase() const override { return _isByHand ? _hands.phase() : _automatic->phase(); }

    /// A person decides when a ride by hand is over.
    bool isDone() const override { return !_isByHand && _automatic->isDone(); }

private:
    std::unique_ptr<VehicleController> _automatic;
    Hands _hands;
    bool _isByHand;
    bool _hasChanged; ///< hands, since the last step
    bool _watches = false;
    std::vector<double> _wishes;
};

} // namespace simulation
