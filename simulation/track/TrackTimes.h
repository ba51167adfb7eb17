// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// What was done to put fixes in order.
struct TimeOrder
{
    std::vector<TrackProblem> dropped; ///< fixes whose time cannot be right, in the file's order
    bool isReversed = false;           ///< the file has the last fix first
};

/// Leaves of the fixes those whose times rise, as many as possible: one wrong clock drops one fix. `parts`:
/// where segments begin that are put in the order of their times first. Most fixes earlier than the one
/// before: the file is read backwards. Then fixes at the begin and the end, a tenth at most, that are more
/// than 30 days from the others are left out: clocks that had not been set.
/// Cost: n log n. Source: Knuth, *The art of computer programming*, vol. 3, 5.1.4 (longest increasing
/// subsequences); of equally long ones that with the earliest fixes is taken.
TimeOrder orderInTime(std::vector<TrackFix>& fixes, std::span<const std::size_t> parts);

/// Adds a day to the times after each midnight: times of the day that fall by more than half a day, and stay
/// there. One wrong time is no midnight, and the first fix alone is one only if the second is within 6 hours.
/// Units: seconds.
void addDays(std::vector<TrackFix>& fixes);

} // namespace simulation
