// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace trainer
{

/// How an axis of a device moves an input of the vehicle.
struct DeviceAxis
{
    int axis = 0;      ///< of the device, from 0
    std::string input; ///< of the vehicle
    bool isInverted = false;
    double dead = 0.0;  ///< share of the way around the rest in which nothing moves, 0 … 0.9
    double curve = 1.0; ///< exponent: above 1 gentle near the rest, 0.1 … 10
};

/// A button that does what a key does.
struct DeviceButton
{
    int button = 0; ///< from 0
    int key = 0;    ///< of keyOf()
};

/// What a device is for. `name`: part of the device's own name, whatever its case; "*": of any.
struct DeviceMap
{
    std::string name;
    std::vector<DeviceAxis> axes;
    std::vector<DeviceButton> buttons;
};

/// The value of an input for the place of an axis, -1 … 1. The rest is the middle of an input that goes both
/// ways, and the lower end of any other (a pedal, a lever). Units: of the input, `least` … `most`.
double inputOf(const DeviceAxis& axis, double place, double least, double most);

/// The first map that fits a device's name; null: none.
const DeviceMap* mapFor(const std::vector<DeviceMap>& maps, std::string_view name);

/// Reads a devices file (docs/reference/devices-file.md). `name` stands for the file in errors.
/// Errors, with the line: no or another first line, an unknown word, key or number, an axis before any
/// device, more than 10 000 lines.
foundation::Result<std::vector<DeviceMap>> parseDevices(std::string_view text, const std::string& name);

/// Errors: besides those a file that cannot be read or is larger than 1 MiB.
foundation::Result<std::vector<DeviceMap>> readDevices(const std::filesystem::path& file);

} // namespace trainer
