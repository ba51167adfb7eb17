// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/Yards.h"

#include <algorithm>
#include <vector>

#include "scenery/buildings/Outline.h"
#include "worldmaking/plan/PlanGrid.h"

namespace worldmaking
{

namespace
{

/// How much of the plane houses cover. A part over another one counts once, for the one on the ground.
class HouseShares
{
public:
    explicit HouseShares(std::span<const House> houses)
    {
        for (const House& house : houses)
        {
            const scenery::Building& building = house.building;
            const MapBox box = boxOf(building.rings.front());
            const glm::dvec2 sizeM = box.high - box.low;
            if (building.liftedM > 0.0 || !(sizeM.x * sizeM.y > 0.0)) continue;
            _grid.add(_houses.size(), box);
            _houses.push_back({box, std::min(scenery::areaOf(building.rings) / (sizeM.x * sizeM.y), 1.0)});
        }
    }

    /// The share of a square that houses cover.
    double in(const MapBox& square) const
    {
        double coveredM2 = 0.0;
        _grid.near(square,
                   [&](std::size_t i)
                   {
                       const glm::dvec2 size = glm::max(glm::min(square.high, _houses[i].box.high) -
                                                            glm::max(square.low, _houses[i].box.low),
                                                        glm::dvec2(0.0));
                       coveredM2 += _houses[i].share * size.x * size.y;
                   });
        const glm::dvec2 size = square.high - square.low;
        return coveredM2 / (size.x * size.y);
    }

private:
    struct BoxShare
    {
        MapBox box;
        double share; ///< of the box that the house covers
    };
    std::vector<BoxShare> _houses;
    PlanGrid _grid;
};

} // namespace

std::size_t layYards(CoverRaster& cover, std::span<const House> houses)
{
    const HouseShares shares(houses);
    const glm::dvec2 half(0.5 * kYardLookM);
    std::size_t yards = 0;
    cover.change(Cover::garden,
                 [&](const glm::dvec2& place)
                 {
                     if (shares.in({place - half, place + half}) <= kYardShare) return Cover::garden;
                     ++yards;
                     return Cover::yard;
                 });
    return yards;
}

} // namespace worldmaking
