// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "input/DeviceFile.h"
#include "input/Devices.h"
#include "input/SeatKeys.h"
#include "simulation/control/Hands.h"

namespace trainer
{

/// Moves hands by devices: an axis that has moved since the last look puts its input, a button does what its
/// key does. An axis that rests takes nothing from the keys. Threads: one.
class DeviceHands
{
public:
    explicit DeviceHands(std::vector<DeviceMap> maps) : _maps(std::move(maps)) {}

    /// `states`: of Devices. `hands`: null: buttons alone count.
    void apply(const std::vector<DeviceState>& states, simulation::Hands* hands, SeatKeys& keys);

private:
    struct Seen
    {
        std::vector<double> axes;
        std::vector<bool> isPressed;
    };

    void applyAxes(const DeviceState& state, const DeviceMap& map, Seen& seen,
                   simulation::Hands& hands) const;
    void forgetGone(const std::vector<DeviceState>& states, SeatKeys& keys);
    static void applyButtons(const DeviceState& state, const DeviceMap& map, Seen& seen, SeatKeys& keys);

    std::vector<DeviceMap> _maps;
    std::map<std::string, Seen> _seen; ///< by the device's name
};

} // namespace trainer
