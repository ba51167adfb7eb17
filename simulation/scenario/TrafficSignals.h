// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulation/scenario/SourceLine.h"

namespace simulation
{

/// A part of the cycle of a controller: its signals keep their states for so long.
struct SignalPhase
{
    std::string name;
    double durationS = 0.0;
    std::vector<std::pair<std::string, std::string>> states; ///< signal, state

    bool operator==(const SignalPhase&) const = default;
};

/// Changes traffic signals in a cycle of phases.
struct TrafficSignalController
{
    SourceLine source;
    std::string name;
    double delayS = 0.0;   ///< of its first phase behind that of `reference`, or behind the start
    std::string reference; ///< another controller; empty: none
    std::vector<SignalPhase> phases;

    bool operator==(const TrafficSignalController&) const = default;
};

/// Puts a controller at the begin of one of its phases.
struct TrafficSignalControllerAction
{
    static constexpr std::string_view kElement = "TrafficSignalControllerAction";

    SourceLine source;
    std::string controller;
    std::string phase;

    bool operator==(const TrafficSignalControllerAction&) const = default;
};

} // namespace simulation
