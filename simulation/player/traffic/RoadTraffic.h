// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "simulation/player/traffic/TrafficFlow.h"
#include "simulation/player/traffic/TrafficPlan.h"

namespace simulation
{

/// The traffic actions of a play that go on. A vehicle that comes to the end of the last road vanishes. The
/// same scenario, roads and seed give the same traffic.
class RoadTraffic
{
public:
    /// `plan` must outlive it.
    RoadTraffic(const TrafficPlan& plan, std::uint64_t seed) : _plan(&plan), _seed(seed) {}

    /// Begins an action; it takes effect with the next step. A stop ends those of its name, one without a
    /// name all.
    void begin(const TrafficAction& action);

    void step(TrafficScene& scene);

    const TrafficPlan& plan() const { return *_plan; }
    std::uint64_t seed() const { return _seed; }

private:
    struct Named
    {
        const TrafficAction* action;
        std::unique_ptr<TrafficFlow> flow;
    };

    const TrafficPlan* _plan;
    std::uint64_t _seed;
    std::uint64_t _begun = 0;
    std::vector<Named> _flows;
};

} // namespace simulation
