// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "request/PlayRequest.h"
#include "simulation/tour/RideConditions.h"

namespace trainer
{

/// How a ride is played.
struct RideRequest
{
    PlayRequest play; ///< pictures, and the table of motion
    bool isHeadless = false;
    double durationS = 600.0;     ///< at most; in a window as long as somebody sits there
    std::filesystem::path inputs; ///< recorded inputs in place of the autopilot or driver
    std::filesystem::path recordInputs;
    simulation::RideConditions conditions; ///< time of day and weather

    /// Whether somebody sits in it: a window is asked for, or nothing else is.
    bool hasWindow() const;
};

} // namespace trainer
