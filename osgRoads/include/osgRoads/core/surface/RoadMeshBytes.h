// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Returns a mesh as bytes, for PagedRoadMesh::in(): a sixth of what it takes in memory. Numbers are the
/// machine's.
/// Absent: they would be more than `mostBytes`.
std::optional<std::string> bytesOf(const RoadMesh& mesh,
                                   std::uintmax_t mostBytes = std::numeric_limits<std::uintmax_t>::max());

} // namespace osgRoads::core
