// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

namespace trainer
{

/// The arguments of `trainer devices`.
struct DevicesRequest
{
    double liveS = 0.0;                ///< how long to show them
    std::filesystem::path devicesFile; ///< empty: none
};

/// Prints every device with its axes and buttons and what the devices file makes of it, then, for so long,
/// where they are.
/// Errors: a devices file that cannot be read, a build or a machine without access to devices.
foundation::Outcome listDevices(const DevicesRequest& request);

} // namespace trainer
