// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/StandBuildings.h"

#include <algorithm>

#include "scenery/buildings/BuildingRules.h"

namespace scenery
{

namespace
{

constexpr double kStepM = 1.0;

} // namespace

std::optional<GroundSpan> groundUnder(const std::vector<std::vector<glm::dvec2>>& rings,
                                      const GroundHeight& ground)
{
    GroundSpan span{1e300, -1e300};
    const auto look = [&](const glm::dvec2& place)
    {
        const auto heightM = ground(place.x, place.y);
        if (!heightM) return false;
        span.lowM = std::min(span.lowM, *heightM);
        span.highM = std::max(span.highM, *heightM);
        return true;
    };
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
            const int steps = std::max(1, static_cast<int>(glm::length(to - from) / kStepM));
            for (int k = 0; k < steps; ++k)
                if (!look(glm::mix(from, to, static_cast<double>(k) / steps))) return std::nullopt;
        }
    return span;
}

StandingBuildings standBuildings(const osgTerrainROAM::core::ShapeSet& shapes, const GroundHeight& ground)
{
    StandingBuildings standing;
    for (const auto& shape : shapes.shapes)
    {
        const auto id = static_cast<std::uint64_t>(shape.id);
        auto building =
            shape.isArea() ? buildingOf(shape.rings, shape.tags, id) : towerOf(shape.point, shape.tags, id);
        if (!building)
        {
            ++standing.unusable;
            continue;
        }
        const auto span = groundUnder(building->rings, ground);
        if (!span)
        {
            ++standing.beyondGround;
            continue;
        }
        const double floorM =
            std::min(span->highM, span->lowM + std::max(kMostCellarM, 0.5 * building->eavesM));
        standing.buildings.push_back({*std::move(building), floorM, span->lowM - kFootM});
    }
    return standing;
}

} // namespace scenery
