// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scenery/placement/Measures.h"
#include "scenery/placement/Placement.h"
#include "scenery/placement/SceneryDescription.h"
#include "scenery/placement/Surroundings.h"

namespace scenery
{

/// What became of one field.
struct FieldReport
{
    std::string name;
    std::uint32_t wanted = 0, placed = 0;
};

/// A scenery in its place.
struct PlacedScenery
{
    std::vector<Placement> placements; ///< by field
    std::vector<Corridor> streets;     ///< of settlements
    std::vector<FieldReport> reports;  ///< in the order of the description's fields
};

/// Places all objects of a description; nothing overlaps what stands already, and where a field finds no room, it stays short of its
/// count. Settlements come first, then what is parked, rows, and what is scattered; within one arrangement by name: the order of fields in
/// the description does not matter, nor does anything but the arguments.
/// `measures`: of objectsOf(description), in that order.
/// Cost: some 10 to 30 µs an object that finds its place soon; at most 30 places are tried for each.
/// Memory: 100 B an object while it works.
PlacedScenery placeScenery(const SceneryDescription& description, std::span<const Measures> measures,
                           const Ground& ground, const Ways& ways);

} // namespace scenery
