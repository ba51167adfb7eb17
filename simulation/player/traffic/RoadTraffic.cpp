// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/traffic/RoadTraffic.h"

namespace simulation
{

void RoadTraffic::begin(const TrafficAction& action)
{
    if (std::holds_alternative<TrafficStop>(action.content))
    {
        std::erase_if(_flows, [&](const Named& named)
                      { return action.name.empty() || named.action->name == action.name; });
        return;
    }
    std::erase_if(_flows, [&](const Named& named) { return named.action == &action; }); // it begins anew
    RandomDraw draw(_seed, action.name, ++_begun);
    std::visit(
        [&](const auto& content)
        {
            if constexpr (!std::is_same_v<std::decay_t<decltype(content)>, TrafficStop>)
                _flows.push_back({&action, makeFlow(content, _plan->vehiclesOf(action), std::move(draw))});
        },
        action.content);
}

void RoadTraffic::step(TrafficScene& scene)
{
    if (!scene.roads()) return;
    for (int i = 0; i < static_cast<int>(scene.scenario().entities.size()); ++i)
        if (scene.isTraffic(i) && scene.isPresent(i) && scene.motion(i).state().isAtEndOfRoad)
            scene.vanish(i);
    for (Named& named : _flows)
        named.flow->step(scene);
}

} // namespace simulation
