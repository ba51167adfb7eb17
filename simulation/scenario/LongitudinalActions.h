// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulation/scenario/Distance.h"
#include "simulation/scenario/Dynamics.h"
#include "simulation/scenario/SourceLine.h"

// Source: ASAM OpenSCENARIO XML 1.3, LongitudinalAction.

namespace simulation
{

struct AbsoluteTargetSpeed
{
    double speedMps = 0.0;

    bool operator==(const AbsoluteTargetSpeed&) const = default;
};

/// The speed of another entity plus or times a value.
struct RelativeTargetSpeed
{
    static constexpr std::string_view kElement = "RelativeTargetSpeed";

    std::string entity;
    double value = 0.0;
    bool isFactor = false;
    bool isContinuous = false; ///< the action never ends: the speed follows that of the other

    bool operator==(const RelativeTargetSpeed&) const = default;
};

using SpeedTarget = std::variant<AbsoluteTargetSpeed, RelativeTargetSpeed, Unsupported>;

struct SpeedAction
{
    SourceLine source;
    TransitionDynamics dynamics;
    SpeedTarget target;

    bool operator==(const SpeedAction&) const = default;
};

/// Limits of speed and its changes; absent: as the vehicle's performance has it.
struct DynamicConstraints
{
    std::optional<double> maxSpeedMps;
    std::optional<double> maxAccelerationMps2, maxDecelerationMps2;
    std::optional<double> maxAccelerationRateMps3, maxDecelerationRateMps3;

    bool operator==(const DynamicConstraints&) const = default;
};

struct SpeedProfileAction
{
    static constexpr std::string_view kElement = "SpeedProfileAction";

    struct Entry
    {
        std::optional<double> timeS; ///< since the entry before
        double speedMps = 0.0;

        bool operator==(const Entry&) const = default;
    };

    SourceLine source;
    bool isSmooth = false; ///< followingMode `follow`: within the limits of the change of acceleration
    DynamicConstraints constraints;
    std::vector<Entry> entries;

    bool operator==(const SpeedProfileAction&) const = default;
};

/// Keeps a distance or a time gap to another entity.
struct LongitudinalDistanceAction
{
    static constexpr std::string_view kElement = "LongitudinalDistanceAction";

    SourceLine source;
    std::string entity;
    std::optional<double> distanceM;
    std::optional<double> timeGapS;
    bool isContinuous = false;
    DistanceMeasure measure;
    int side = 0; ///< displacement: 1 behind the other (any where 0), -1 in front of it
    DynamicConstraints constraints;
    bool isLimited = false; ///< there are DynamicConstraints

    bool operator==(const LongitudinalDistanceAction&) const = default;
};

} // namespace simulation
