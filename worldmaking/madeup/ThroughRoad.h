// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "worldmaking/madeup/RoadSearch.h"
#include "worldmaking/madeup/WayWeb.h"

namespace worldmaking
{

/// Builds one road through a place, or through the reachable place nearest to it, from edge to edge of the
/// ground within a box: of the ways out, the two that together are shortest for the distance of their ends.
/// For ground with one settlement.
/// False: no two ways lead out. Frame: the plane.
bool roadThrough(const glm::dvec2& place, const MapBox& box, std::string_view kind, RoadSearch& search,
                 WayWeb& web);

} // namespace worldmaking
