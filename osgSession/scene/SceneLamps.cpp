// SPDX-License-Identifier: Apache-2.0
#include "SceneLamps.h"

#include <vector>

#include "scenery/roads/LayRoads.h"

namespace trainer
{

std::shared_ptr<scenery::SettlementLights> settlementLights(const MapScenery& map,
                                                            const scenery::MappedLamps& mapped,
                                                            const osgRoads::core::PlacedNetwork* roads,
                                                            const foundation::HeightInPlan& ground)
{
    std::vector<scenery::StreetLine> streets;
    if (roads && !(map.houses.empty() && mapped.posts.empty() && mapped.lit.empty()))
        for (const auto& road : scenery::farRoads(*roads))
            for (const auto& path : road.paths)
                streets.push_back({path, road.style.widthM});
    const auto lamps = scenery::streetLampsAlong(streets, map.houses, mapped);
    auto lights = std::make_shared<scenery::SettlementLights>(lamps, map.panes, map.lights, ground);
    return lights->count() > 0 ? lights : nullptr;
}

} // namespace trainer
