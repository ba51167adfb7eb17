// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace osgPMObjects::core
{

/// The state of a rule with hysteresis for one object in one view, kept by the caller: the last level or row
/// chosen.
struct HeldLevel
{
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t level = kNone; ///< kNone: not chosen yet, or forgotten while the object was not visible

    bool isHeld() const { return level != kNone; }
};

/// The default width of hysteresis, a factor of distance. A rule chooses with its tolerance divided by the
/// band, and holds that level until the tolerance itself is exceeded or the other end of the band is reached.
/// A distance that varies by ±5 % changes by 1.05 / 0.95 = 1.105, less than the band, so the level switches
/// at most once.
inline constexpr double kDefaultBand = 1.12;

/// Moves the held row up while the next row is due, and down while its own is over.
/// `isDue(row)`: whether to change to `row` from the row before it; `isOver(row)`: whether to change back
/// from `row`. Both must fall with the row, and no row may be due and over at once. `held`: the last answer,
/// or none; `last`: the last row.
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
