// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "scenery/placement/PlaceScenery.h"

namespace scenery
{

/// What keeps a placed scenery from being one: rooms that overlap (each core against each room), an object in a corridor or on a street,
/// outside its field's area, heights or cover; one whose foundation does not reach the ground somewhere at its base's rim, or that
/// is deeper in it than kMostBuriedM or kMostSunkM allow; a scale out of range. Empty: nothing does.
/// Looks at the rim twice as closely as placement does. Cost: n log n and the neighbours along one axis.
std::string defectOf(const PlacedScenery& placed, const SceneryDescription& description,
                     std::span<const Measures> measures, const Ground& ground, const Ways& ways);

} // namespace scenery
