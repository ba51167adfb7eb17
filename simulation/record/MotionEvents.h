// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/record/MotionTable.h"

namespace simulation
{

/// How events of one kind lie in two tables.
struct EventMatch
{
    std::size_t count = 0;     ///< in the reference
    std::size_t unmatched = 0; ///< that one table has within half a second and the other has not
    double largestS = 0.0;     ///< between two that are matched
};

/// When an entity changed its lane, began to touch another, and changed its acceleration by more than 1 m/s²
/// from one row to the next.
struct EventDifference
{
    std::string entity;
    EventMatch laneChanges, collisions, speedKinks;
};

/// Compares the events of two tables, seen at the rows of the reference; entities as compareMotions(). A kink
/// that lies between two rows counts at the one with the greater change. Tables without the columns lane_id
/// and collision_ids have no such events.
std::vector<EventDifference> compareEvents(const MotionTable& table, const MotionTable& reference);

/// Whether all events are matched, and none lies farther apart than `mostS`.
bool isWithin(const EventDifference& difference, double mostS);

} // namespace simulation
