// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace osgPMObjects::core
{

/// What a rule remembers of one object in one view, kept by the caller: the level or row that it chose last.
struct HeldLevel
{
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t level = kNone; ///< kNone: not chosen yet, or forgotten while the object was out of sight

    bool isHeld() const { return level != kNone; }
};

/// The width of the band that rules with a tolerance keep a level for. A rule asks with its tolerance divided by the band,
/// and holds the answer until the tolerance itself would be broken, or the band's other end is reached: a factor of
/// `kDefaultBand` in distance either way. Back and forth by 5 % changes it by 1.05 / 0.95 = 1.105, so nothing switches
/// more than once.
inline constexpr double kDefaultBand = 1.12;

/// The row that is held: it goes up while the next one is due, and down while its own is not.
/// `isDue(row)`: whether to go on to a row from the one before it; `isOver(row)`: whether to go back from it. Both fall
/// with the row, and no row is due and over at once. `held`: none, or the last answer; `last`: the last row.
template<class IsDue, class IsOver>
std::uint32_t heldRow(HeldLevel held, std::uint32_t last, const IsDue& isDue, const IsOver& isOver)
{
    std::uint32_t row = held.isHeld() ? held.level : 0;
    if (row > last) row = last;
    while (row < last && isDue(row + 1))
        ++row;
    while (row > 0 && isOver(row))
        --row;
    return row;
}

} // namespace osgPMObjects::core
