// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "input/DeviceFile.h"
#include "input/Devices.h"
#include "input/SeatKeys.h"
#include "simulation/control/ManualController.h"

namespace trainer
{

/// Applies devices to manual control: an axis that has moved since the last look puts its input, a button
/// does what its key does. An axis that rests takes nothing from the keys. Threads: one.
class DeviceInputs
{
public:
    explicit DeviceInputs(std::vector<DeviceMap> maps) : _maps(std::move(maps)) {}

    /// `states`: of Devices. `manual`: null: buttons alone count.
    void apply(const std::vector<DeviceState>& states, simulation::ManualController* manual, SeatKeys& keys);

private:
    struct Seen
    {
        std::vector<double> axes;
        std::vector<bool> isPressed;
    };

    void applyAxes(const DeviceState& state, const DeviceMap& map, Seen& seen,
                   simulation::ManualController& manual) const;
    void forgetGone(const std::vector<DeviceState>& states, SeatKeys& keys);
    static void applyButtons(const DeviceState& state, const DeviceMap& map, Seen& seen, SeatKeys& keys);

    std::vector<DeviceMap> _maps;
    std::map<std::string, Seen> _seen; ///< by the device's name
};

} // namespace trainer
