// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include <osgRoads/core/surface/RoadMesh.h>

namespace foundation
{
class ValueTaker;
}

namespace osgRoads::core
{

/// How many vertices and indices a mesh has.
struct MeshSize
{
    std::uint32_t vertices = 0, indices = 0;
};

/// Appends all of a mesh but its vertices and indices.
void appendOutline(std::string& bytes, const RoadMesh& mesh);

/// False: appendOutline() did not append what follows. The ranges of chunks lie within `size`.
bool takeOutline(foundation::ValueTaker& taker, RoadMesh& outline, MeshSize& size);

} // namespace osgRoads::core
