// SPDX-License-Identifier: Apache-2.0
#include "SceneLamps.h"

#include <utility>
#include <vector>

#include "scenery/lights/StreetLampBytes.h"
#include "scenery/roads/LayRoads.h"

namespace trainer
{

namespace
{

using scenery::StreetLamp;

std::vector<StreetLamp> lampsAlong(const osgRoads::core::PlacedNetwork* roads,
                                   const std::vector<glm::dvec2>& houses, const scenery::MappedLamps& mapped)
{
    std::vector<scenery::StreetLine> streets;
    if (roads)
        for (const auto& road : scenery::farRoads(*roads))
            for (const auto& path : road.paths)
                streets.push_back({path, road.style.widthM});
    return scenery::streetLampsAlong(streets, houses, mapped);
}

/// The mark of all that lamps follow from.
foundation::ContentMark markOf(foundation::ContentMark mark, const std::vector<glm::dvec2>& houses,
                               const scenery::MappedLamps& mapped)
{
    mark.add(houses).add(mapped.posts);
    for (const auto* lines : {&mapped.lit, &mapped.unlit})
    {
        mark.addWord(lines->size());
        for (const auto& line : *lines)
            mark.add(line);
    }
    return mark;
}

} // namespace

std::shared_ptr<scenery::SettlementLights>
settlementLights(MapScenery map, const scenery::MappedLamps& mapped,
                 const osgRoads::core::PlacedNetwork* roads, foundation::HeightInPlan ground,
                 const std::optional<foundation::ContentMark>& roadsMark, const foundation::KeptFrom& kept)
{
    std::vector<StreetLamp> lamps;
    const auto make = [&] { return lampsAlong(roads, map.houses, mapped); };
    if (!(map.houses.empty() && mapped.posts.empty() && mapped.lit.empty()))
        lamps = roadsMark
                    ? kept.findOrMake("lamps", markOf(*roadsMark, map.houses, mapped), scenery::streetLampsIn,
                                      make, [](const std::vector<StreetLamp>& made) { return bytesOf(made); })
                    : make();
    auto lights = std::make_shared<scenery::SettlementLights>(lamps, std::move(map.panes),
                                                              std::move(map.lights), std::move(ground));
    return lights->count() > 0 ? lights : nullptr;
}

} // namespace trainer
