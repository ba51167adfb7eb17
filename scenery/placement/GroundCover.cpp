// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/GroundCover.h"

#include <numbers>

#include "scenery/models/Dice.h"

namespace scenery
{

namespace
{

constexpr int kSlotsPerSide = 15; ///< one thing at most in each: 3.5 a square metre
constexpr double kHerbShare = 0.05, kStoneShare = 0.5;
constexpr double kTwigShare = 0.2, kWoodGrassShare = 0.35; ///< of a wood's floor

std::uint8_t reachOf(double unit)
{
    if (unit < kCoverShares[0]) return 0;
    return unit < kCoverShares[0] + kCoverShares[1] ? 1 : 2;
}

/// Which thing stands on this ground; `unit`, `other`: two random numbers.
std::optional<CoverShape> shapeOn(const CoverGround& ground, double unit, double other)
{
    if (unit < ground.grass) return other < kHerbShare ? CoverShape::herb : CoverShape::grass;
    unit -= ground.grass;
    if (unit < ground.stones) return other < kStoneShare ? std::optional(CoverShape::stone) : std::nullopt;
    unit -= ground.stones;
    if (unit >= ground.litter || other >= kTwigShare + kWoodGrassShare) return std::nullopt;
    return other < kTwigShare ? CoverShape::twig : CoverShape::grass;
}

} // namespace

std::vector<CoverThing> coverOf(glm::ivec2 cell, std::uint8_t leastReach, const CoverQuery& query)
{
    std::vector<CoverThing> things;
    constexpr double kSlotM = kCoverCellM / kSlotsPerSide;
    for (int slot = 0; slot < kSlotsPerSide * kSlotsPerSide; ++slot)
    {
        models::Dice dice((static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x)) << 32 |
                           static_cast<std::uint32_t>(cell.y)) *
                              256U +
                          static_cast<std::uint64_t>(slot));
        CoverThing thing;
        thing.reach = reachOf(dice.unit());
        if (thing.reach < leastReach) continue;
        const glm::dvec2 inCell =
            kSlotM * glm::dvec2(slot % kSlotsPerSide + dice.unit(), slot / kSlotsPerSide + dice.unit());
        const glm::dvec2 place = kCoverCellM * glm::dvec2(cell) + inCell;
        const auto ground = query(place);
        if (!ground) continue;
        const auto shape = shapeOn(*ground, dice.unit(), dice.unit());
        if (!shape) continue;
        thing.shape = *shape;
        thing.position = {place, ground->heightM};
        thing.headingRad = dice.between(0.0, 2.0 * std::numbers::pi);
        thing.scale = dice.between(0.8, 1.8);
        things.push_back(thing);
    }
    return things;
}

} // namespace scenery
