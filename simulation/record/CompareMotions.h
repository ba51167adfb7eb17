// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/record/ComparePlaces.h"
#include "simulation/record/MotionEvents.h"

namespace simulation
{

/// The largest difference, when it was, and the root of the mean of the squares.
struct Spread
{
    double largest = 0.0;
    double largestAtS = 0.0;
    double rms = 0.0;
};

/// How one entity moved in two tables.
struct MotionDifference
{
    std::string entity;
    std::size_t rows = 0;          ///< compared
    std::size_t unmatchedRows = 0; ///< of the reference, in which the other table does not have the entity
    Spread positionM;              ///< in space
    Spread headingDeg;
    Spread speedMps;
};

/// Compares a table with a reference at every row of the reference: with the row of the same time, within a
/// microsecond. Entities are matched by name, in the order of the reference. One that `table` has alone is
/// not told.
std::vector<MotionDifference> compareMotions(const MotionTable& table, const MotionTable& reference);

struct MotionLimits
{
    double positionM = 0.05;
    double headingDeg = 0.1;
};

/// Whether every row of the reference was matched and stays within the limits; the limits themselves are
/// within.
bool isWithin(const MotionDifference& difference, const MotionLimits& limits);

/// The differences as JSON: an object with `limits`, `entities` and `within`. `events`: of the same entities;
/// `places`: of those that have a way.
std::string differencesText(const std::vector<MotionDifference>& differences,
                            const std::vector<EventDifference>& events,
                            const std::vector<PlaceDifference>& places, const MotionLimits& limits);

} // namespace simulation
