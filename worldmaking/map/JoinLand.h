// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "worldmaking/map/LandMap.h"

namespace worldmaking
{

/// Adds the shapes of `other` to `map`, without those that `map` has already: same form, place and tags, as
/// at the seams of extracts. Returns how many those were.
std::size_t joinLand(LandMap& map, LandMap other);

/// Adds the streets of `other`: nodes at the same place (1e-7°) become one, ways and rules get ids above
/// those of `map`.
void joinStreets(StreetMap& map, StreetMap other);

} // namespace worldmaking
