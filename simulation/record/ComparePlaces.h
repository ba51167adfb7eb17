// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/record/MotionTable.h"

namespace simulation
{

/// The difference that is largest, with its sign, where it was, and the root of the mean of the squares.
struct PlaceSpread
{
    double largest = 0.0;
    double largestAtM = 0.0; ///< along the way of the reference
    double rms = 0.0;
};

/// How one entity moved along the way that it has in another table. Differences are those of the table from
/// the reference at the same place. Units: metres, m/s, degrees, seconds.
struct PlaceDifference
{
    std::string entity;
    double wayM = 0.0;          ///< how long the way of the reference is, in the plan
    double coveredM = 0.0;      ///< of it, from the first place that is met to the last
    std::size_t places = 0;     ///< compared
    std::size_t beyondRows = 0; ///< of the table, before the begin of the way or after its end
    PlaceSpread besideM;        ///< to the left, in the plan
    PlaceSpread heightM, speedMps, timeS;
    std::optional<PlaceSpread> bankDeg; ///< right side down; nothing: one of the tables does not tell
};

/// Compares each entity of a reference with that of the same name in a table: each of its places, 0.1 m apart
/// at least, with the nearest one on the way of the reference, in the plan. A way that crosses itself is
/// followed: after the first place, the nearest is looked for from 100 m before the last one on, as far ahead
/// as the entity may have gone. Entities that one of the tables lacks, and ways shorter than 1 m, are left
/// out.
std::vector<PlaceDifference> comparePlaces(const MotionTable& table, const MotionTable& reference);

} // namespace simulation
