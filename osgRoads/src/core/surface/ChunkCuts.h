// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// Returns the s at which the chunks of a lane section begin and end, ascending: where marks, widths,
/// heights, profiles or elements of the plan view begin anew, at `more`, and in between so that no chunk is
/// longer than `longestM`.
std::vector<double> chunkCuts(const Road& road, const LaneSection& section, const std::vector<double>& more,
                              double longestM);

} // namespace osgRoads::core
