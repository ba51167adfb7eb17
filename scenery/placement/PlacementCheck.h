// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "scenery/placement/PlaceScenery.h"

namespace scenery
{

/// Lists the faults of a placed scenery; empty when it has none. Checked: overlaps (each core against each
/// room); objects in a corridor or on a street; objects outside the area, heights or land cover of their
/// field; foundations that do not reach the ground at the rim of the base; objects deeper in the ground than
/// kMostBuriedM or kMostSunkM; scales out of range. The rim is sampled twice as densely as in placement.
/// Cost: n log n and the neighbours along one axis.
std::string defectOf(const PlacedScenery& placed, const SceneryDescription& description,
                     std::span<const Measures> measures, const Ground& ground, const Ways& ways);

} // namespace scenery
