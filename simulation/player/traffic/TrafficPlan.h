// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// The vehicles that the traffic of a scenario may need at the same time. They are entities like others,
/// which are not there until a traffic action puts them on the road, and again when they leave it; so who
/// plays, draws and records needs no second kind of entity. A swarm and an area have as many as they name, a
/// source kOfASource. Which kinds of vehicles they are is drawn by the seed.
class TrafficPlan
{
public:
    static constexpr int kOfASource = 60;
    static constexpr std::size_t kMost = 2000; ///< of all actions together

    TrafficPlan() = default;

    /// Adds the vehicles behind the entities of the scenario, with names of their own: that of the traffic
    /// and a number.
    TrafficPlan(Scenario& scenario, std::uint64_t seed);

    /// Returns the indices of the entities that an action of that scenario may use. Empty: it is a sink or a
    /// stop.
    const std::vector<int>& vehiclesOf(const TrafficAction& action) const;

    bool isTraffic(int entity) const { return _first >= 0 && entity >= _first; }

private:
    void add(Scenario& scenario, const TrafficAction& action, std::uint64_t seed);

    std::map<const TrafficAction*, std::vector<int>> _vehicles;
    int _first = -1;
};

} // namespace simulation
