// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "simulation/scenario/TrafficSignals.h"

namespace simulation
{

/// The states of traffic signals: those that actions have set, and those of the cycles of controllers. A
/// phase that begins sets its signals; an action in it holds until the next one begins. A controller with a
/// delay behind another one begins its first phase so many seconds after that one's; its cycle is the same
/// before and after that. Units: seconds.
class SignalPlan
{
public:
    /// `controllers` must outlive it.
    explicit SignalPlan(const std::vector<TrafficSignalController>& controllers);

    /// Sets the signals of the phases that have begun since the last call.
    void advanceTo(double timeS);

    void setState(const std::string& signal, const std::string& state) { _states[signal] = state; }

    /// Begins a phase now; the cycle goes on from there. Does nothing where there is no such controller or
    /// phase.
    void beginPhase(const TrafficSignalControllerAction& action, double timeS);

    const std::map<std::string, std::string>& states() const { return _states; }
    const std::map<std::string, std::string>& phases() const { return _phases; } ///< of each controller

private:
    struct Cycle
    {
        const TrafficSignalController* controller;
        double startS;
        double lengthS;
        int phase = -1;
    };

    static int phaseAt(const Cycle& cycle, double timeS);

    std::vector<Cycle> _cycles;
    std::map<std::string, std::string> _states, _phases;
};

} // namespace simulation
