// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "scenery/placement/Arrangements.h"

namespace scenery
{

namespace
{

constexpr std::uint64_t kTriesEach = 30;

} // namespace

/// Darts: a place, a direction, an object, until there are enough, or too many have missed.
void scatter(Site& site, std::uint32_t wanted)
{
    models::Dice& dice = site.dice();
    for (std::uint64_t tries = wanted * kTriesEach; tries > 0 && site.placed() < wanted; --tries)
    {
        const glm::dvec2 place = site.anyPlace();
        const std::uint32_t object = site.anyObject();
        const double heading = dice.between(-std::numbers::pi, std::numbers::pi);
        site.put(object, place, heading, site.anyScale());
    }
}

} // namespace scenery
