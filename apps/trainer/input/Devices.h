// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace trainer
{

/// A joystick, yoke, wheel or set of pedals as it is now.
struct DeviceState
{
    std::string name;
    std::vector<double> axes;    ///< -1 … 1
    std::vector<bool> isPressed; ///< of the buttons
};

/// The devices at this machine, by SDL; they come and go. Without SDL in the build there are none. Threads:
/// one.
class Devices
{
public:
    Devices();
    ~Devices();
    Devices(const Devices&) = delete;
    Devices& operator=(const Devices&) = delete;

    /// Looks at all of them. Returns a line for each that came or went since the last look.
    std::vector<std::string> update();

    /// In the order in which they came.
    const std::vector<DeviceState>& states() const { return _states; }

    /// Why there can be none; empty: there can.
    const std::string& fault() const { return _fault; }

private:
    std::vector<DeviceState> _states;
    std::vector<std::shared_ptr<void>> _opened; ///< SDL's, beside _states
    std::string _fault;
};

} // namespace trainer
