// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Returns a mesh as bytes, for roadMeshIn(). Numbers are the machine's.
std::string bytesOf(const RoadMesh& mesh);

/// Absent: bytesOf() did not write them. Ranges and indices are checked, so that what is returned can be
/// drawn.
std::optional<RoadMesh> roadMeshIn(std::string_view bytes);

} // namespace osgRoads::core
