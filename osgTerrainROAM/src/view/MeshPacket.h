// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <osgTerrainROAM/core/roam/TerrainMesh.h>

namespace osgTerrainROAM
{

/// The changes of one refinement, copied out of the mesh so that a later refinement may run while this one is
/// drawn. A packet takes a copy of the mesh from state `serial - 1` to state `serial`, or from nothing when
/// `whole`.
/// Threads: immutable once made.
struct MeshPacket
{
    std::uint64_t serial = 0;
    bool whole = false;
    int patchExponent =
        0; ///< of the patches that the vertices are those of, slot by slot; the triangles are one patch's
    std::uint32_t vertexCount = 0; ///< of the mesh in state `serial`, free slots included
    std::uint32_t triangleCount = 0;
    std::vector<core::IndexRange> vertexRanges; ///< where `vertices` go, one range after the other
    std::vector<core::MeshVertex> vertices;
    std::vector<core::IndexRange> triangleRanges;
    std::vector<core::LeafTriangle> triangles;
};

using PacketPtr = std::shared_ptr<const MeshPacket>;

/// The capacity of a buffer for `count` elements: a power of two, so that it is rarely reallocated.
std::uint32_t bufferCapacity(std::uint32_t count);

PacketPtr changedPacket(const core::TerrainMesh& mesh, std::uint64_t serial);
PacketPtr wholePacket(const core::TerrainMesh& mesh, std::uint64_t serial);

} // namespace osgTerrainROAM
