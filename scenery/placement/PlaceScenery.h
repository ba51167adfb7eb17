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

/// The result of one field.
struct FieldReport
{
    std::string name;
    std::uint32_t wanted = 0, placed = 0;
};

/// The placed objects of a scenery.
struct PlacedScenery
{
    std::vector<Placement> placements; ///< by field
    std::vector<Corridor> streets;     ///< of settlements
    std::vector<FieldReport> reports;  ///< in the order of the description's fields
};

/// Places all objects of a description without overlaps. A field that finds no room has fewer objects than
/// wanted. Settlements come first, then parked vehicles, rows and scattered objects, sorted by name within
/// each: the order of the fields does not matter. The result depends on the arguments only.
/// `measures`: of objectsOf(description), in that order. Cost: about 10 to 30 µs for an object that soon
/// finds room; at most 30 positions are tried for each. Memory: 100 B an object while it works.
PlacedScenery placeScenery(const SceneryDescription& description, std::span<const Measures> measures,
                           const Ground& ground, const Ways& ways);

} // namespace scenery
