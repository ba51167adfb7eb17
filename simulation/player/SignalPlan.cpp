// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/SignalPlan.h"

#include <algorithm>
#include <cmath>

namespace simulation
{
namespace
{

constexpr double kSameInstantOfCycleS = 1e-9;

/// The delays of a controller and of those that it refers to; a chain that bites its tail ends there.
double startOf(const std::vector<TrafficSignalController>& controllers, const TrafficSignalController& first)
{
    double startS = first.delayS;
    const TrafficSignalController* at = &first;
    for (std::size_t length = 0; length < controllers.size() && !at->reference.empty(); ++length)
    {
        const auto found = std::find_if(controllers.begin(), controllers.end(),
                                        [&](const auto& other) { return other.name == at->reference; });
        if (found == controllers.end() || &*found == &first) break;
        startS += found->delayS;
        at = &*found;
    }
    return startS;
}

} // namespace

SignalPlan::SignalPlan(const std::vector<TrafficSignalController>& controllers)
{
    for (const TrafficSignalController& controller : controllers)
    {
        double lengthS = 0.0;
        for (const SignalPhase& phase : controller.phases)
            lengthS += phase.durationS;
        if (!controller.phases.empty())
            _cycles.push_back({&controller, startOf(controllers, controller), lengthS});
    }
    advanceTo(0.0);
}

int SignalPlan::phaseAt(const Cycle& cycle, double timeS)
{
    if (!(cycle.lengthS > 0.0)) return 0;
    double left = std::fmod(timeS - cycle.startS + kSameInstantOfCycleS, cycle.lengthS);
    if (left < 0.0) left += cycle.lengthS;
    const std::vector<SignalPhase>& phases = cycle.controller->phases;
    for (std::size_t i = 0; i + 1 < phases.size(); ++i)
    {
        if (left < phases[i].durationS) return static_cast<int>(i);
        left -= phases[i].durationS;
    }
    return static_cast<int>(phases.size()) - 1;
}

void SignalPlan::advanceTo(double timeS)
{
    for (Cycle& cycle : _cycles)
    {
        const int now = phaseAt(cycle, timeS);
        if (now == cycle.phase) continue;
        cycle.phase = now;
        const SignalPhase& phase = cycle.controller->phases[static_cast<std::size_t>(now)];
        _phases[cycle.controller->name] = phase.name;
        for (const auto& [signal, state] : phase.states)
            _states[signal] = state;
    }
}

void SignalPlan::beginPhase(const TrafficSignalControllerAction& action, double timeS)
{
    for (Cycle& cycle : _cycles)
    {
        if (cycle.controller->name != action.controller) continue;
        double before = 0.0;
        for (const SignalPhase& phase : cycle.controller->phases)
        {
            if (phase.name == action.phase)
            {
                cycle.startS = timeS - before;
                cycle.phase = -1;
                advanceTo(timeS);
                return;
            }
            before += phase.durationS;
        }
    }
}

} // namespace simulation
