// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "simulation/scenario/Entity.h"
#include "simulation/scenario/OverrideAction.h"

// Source: ASAM OpenSCENARIO XML 1.3, LightStateAction, AssignControllerAction, TrailerAction.

namespace simulation
{

enum class LightMode
{
    off,
    on,
    flashing,
};

/// Switches a lamp of an entity.
struct LightStateAction
{
    static constexpr std::string_view kElement = "LightStateAction";

    SourceLine source;
    std::string light; ///< brakeLights, indicatorLeft … as the standard names them, or the user
    LightMode mode = LightMode::on;
    double onS = 0.5, offS = 0.5; ///< of flashing

    bool operator==(const LightStateAction&) const = default;
};

/// Moves a part of an entity (a door), or lets a person move: it takes effect in EntityState::animations.
struct AnimationAction
{
    static constexpr std::string_view kElement = "AnimationAction";

    SourceLine source;
    std::string part;                ///< doorFrontLeft …, a motion, a gesture, a file, or the user's word
    double state = 1.0;              ///< to which it goes; a door: 0 closed, 1 open
    std::optional<double> durationS; ///< nothing: at once
    bool isLoop = false;

    bool operator==(const AnimationAction&) const = default;
};

/// Gives an entity another controller; nothing: that domain stays as it is.
struct AssignControllerAction
{
    static constexpr std::string_view kElement = "AssignControllerAction";

    SourceLine source;
    Controller controller;
    std::optional<bool> longitudinal, lateral;
    std::optional<OverrideAction> overrides{}; ///< 1.0: both stand in one ControllerAction

    bool operator==(const AssignControllerAction&) const = default;
};

/// Couples a trailer, or (`trailer` empty) leaves the one that is coupled where it is.
struct TrailerAction
{
    static constexpr std::string_view kElement = "TrailerAction";

    SourceLine source;
    std::string trailer;

    bool operator==(const TrailerAction&) const = default;
};

} // namespace simulation
