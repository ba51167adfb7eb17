// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "scenery/placement/Arrangements.h"

namespace scenery
{

namespace
{

constexpr std::uint32_t kTriesEachPlace = 10;

} // namespace

/// Vehicles just beside the edges of a settlement's streets, in their direction, any way round.
void park(Site& site, std::uint32_t wanted)
{
    std::vector<const Corridor*> streets;
    double lengthM = 0.0;
    for (const auto& [field, street] : site.streets())
        if (site.fieldName(field) == site.field().beside)
        {
            streets.push_back(&street);
            lengthM += glm::length(street.line.back() - street.line.front());
        }
    models::Dice& dice = site.dice();
    for (std::uint32_t tries = streets.empty() ? 0 : wanted * kTriesEachPlace;
         tries > 0 && site.placed() < wanted; --tries)
    {
        double at = dice.between(0.0, lengthM);
        std::size_t number = 0;
        const auto lengthOf = [&](const Corridor& street)
        { return glm::length(street.line.back() - street.line.front()); };
        while (number + 1 < streets.size() && at > lengthOf(*streets[number]))
            at -= lengthOf(*streets[number++]);
        const Corridor& street = *streets[number];
        const glm::dvec2 along = glm::normalize(street.line.back() - street.line.front());
        const std::uint32_t object = site.anyObject();
        const double scale = site.anyScale(), side = dice.chance(0.5) ? 1.0 : -1.0;
        const double off = street.halfWidthM + site.measures(object).radiusM * scale + 0.05;
        const glm::dvec2 place =
            street.line.front() + along * at + glm::dvec2(-along.y, along.x) * (side * off);
        // Right-hand traffic, but for one in five.
        const bool isForward = (side < 0.0) != dice.chance(0.2);
        site.put(object, place, std::atan2(along.y, along.x) + (isForward ? 0.0 : std::numbers::pi), scale);
    }
}

} // namespace scenery
