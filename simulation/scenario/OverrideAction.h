// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "simulation/scenario/SourceLine.h"

// Source: ASAM OpenSCENARIO XML 1.0 to 1.3, OverrideControllerValueAction.

namespace simulation
{

/// Takes one control out of the hands of whoever drives, or gives it back.
struct ControlOverride
{
    bool isActive = false;
    double value = 0.0;   ///< of a pedal 0 to 1
    bool isForce = false; ///< the value is a braking force in newtons

    bool operator==(const ControlOverride&) const = default;
};

enum class GearLever
{
    forward,
    reverse,
    neutral,
    park,
};

struct GearOverride
{
    bool isActive = false;
    GearLever lever = GearLever::forward;

    bool operator==(const GearOverride&) const = default;
};

/// What is absent stays as it is.
struct OverrideAction
{
    static constexpr std::string_view kElement = "OverrideControllerValueAction";

    SourceLine source;
    std::optional<ControlOverride> throttle, brake, clutch, parkingBrake;
    std::optional<GearOverride> gear;

    bool operator==(const OverrideAction&) const = default;
};

} // namespace simulation
