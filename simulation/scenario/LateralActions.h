// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulation/scenario/Distance.h"
#include "simulation/scenario/Dynamics.h"
#include "simulation/scenario/SourceLine.h"

// Source: ASAM OpenSCENARIO XML 1.3, LateralAction.

namespace simulation
{

struct LaneChangeAction
{
    static constexpr std::string_view kElement = "LaneChangeAction";

    SourceLine source;
    TransitionDynamics dynamics;
    int lane = 0;       ///< id, or lanes to the left of that of `entity`
    std::string entity; ///< empty: `lane` is an id
    double targetOffsetM = 0.0;

    bool operator==(const LaneChangeAction&) const = default;
};

struct LaneOffsetAction
{
    static constexpr std::string_view kElement = "LaneOffsetAction";

    SourceLine source;
    DynamicsShape shape = DynamicsShape::step;
    std::optional<double> maxLateralAccelerationMps2;
    bool isContinuous = false;
    double offsetM = 0.0;
    std::string entity; ///< empty: the offset is from the middle of the own lane

    bool operator==(const LaneOffsetAction&) const = default;
};

/// Keeps a distance sideways to another entity.
struct LateralDistanceAction
{
    static constexpr std::string_view kElement = "LateralDistanceAction";

    SourceLine source;
    std::string entity;
    double distanceM = 0.0;
    bool isContinuous = false;
    DistanceMeasure measure;
    int side = 0; ///< displacement: 1 to the left of the other, -1 to its right, 0: where it is
    std::optional<double> maxSpeedMps; ///< sideways; nothing: the distance is there at once

    bool operator==(const LateralDistanceAction&) const = default;
};

} // namespace simulation
