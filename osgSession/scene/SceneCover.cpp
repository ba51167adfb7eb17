// SPDX-License-Identifier: Apache-2.0
#include "SceneCover.h"

#include <utility>

#include "scenery/nodes/GroundShares.h"
#include "scenery/roads/BareGround.h"

namespace trainer
{

std::unique_ptr<scenery::GroundCoverNode> makeCover(const SceneTerrain& terrain)
{
    if (!terrain.terrain || terrain.cornerM != glm::dvec2(0.0)) return nullptr;
    auto query = [shares = std::make_shared<const scenery::GroundShares>(*terrain.terrain),
                  roads = terrain.roads, ground = terrain.ground(),
                  tile = terrain.terrain->tile()](glm::dvec2 place) -> std::optional<scenery::CoverGround>
    {
        const auto sample = ground(place.x, place.y);
        if (!sample || (roads && scenery::isBareByRoads(*roads, {place, sample->heightM})))
            return std::nullopt;
        const auto found = shares->at(place);
        return scenery::CoverGround{sample->heightM, found.grass, found.stones, found.litter};
    };
    return std::make_unique<scenery::GroundCoverNode>(std::move(query), *terrain.terrain->material());
}

std::unique_ptr<scenery::SkyShadeNode> makeSkyShade(SceneTerrain& terrain, const scenery::SkyOccluders* more)
{
    if (!terrain.terrain || terrain.cornerM != glm::dvec2(0.0)) return nullptr;
    scenery::SkyOccluders occluders;
    for (StandingPart& part : terrain.standing)
        occluders.add(std::exchange(part.occluders, {}));
    if (more) occluders.add(*more);
    if (occluders.bodies.empty() && occluders.walls.empty()) return nullptr;
    return std::make_unique<scenery::SkyShadeNode>(std::move(occluders), terrain.ground().heights());
}

} // namespace trainer
