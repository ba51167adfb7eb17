// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "scenery/placement/Arrangements.h"

namespace scenery
{

namespace
{

constexpr std::uint32_t kTriesAGroup = 200;

/// One avenue or orchard about a place; what does not find room in it is left out.
void plantGroup(Site& site, glm::dvec2 middle, double headingRad, std::uint32_t wanted)
{
    const RowLayout& layout = site.field().rows;
    const glm::dvec2 along(std::cos(headingRad), std::sin(headingRad)), across(-along.y, along.x);
    const int places = 1 + static_cast<int>(layout.lengthM / layout.spacingM);
    for (int row = 0; row < layout.rows; ++row)
        for (int i = 0; i < places && site.placed() < wanted; ++i)
        {
            const glm::dvec2 place = middle + along * ((i - 0.5 * (places - 1)) * layout.spacingM) +
                                     across * ((row - 0.5 * (layout.rows - 1)) * layout.betweenM);
            const std::uint32_t object = site.anyObject();
            const double turn = site.dice().between(-std::numbers::pi, std::numbers::pi);
            site.put(object, place, turn, site.anyScale());
        }
}

} // namespace

void plantRows(Site& site, std::uint32_t wanted)
{
    models::Dice& dice = site.dice();
    for (std::uint32_t tries = kTriesAGroup + wanted; tries > 0 && site.placed() < wanted; --tries)
    {
        const glm::dvec2 middle = site.anyPlace();
        const double heading = dice.between(0.0, std::numbers::pi);
        if (site.isInArea(middle)) plantGroup(site, middle, heading, wanted);
    }
}

} // namespace scenery
