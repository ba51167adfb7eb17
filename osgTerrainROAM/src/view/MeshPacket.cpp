// SPDX-License-Identifier: Apache-2.0
#include "MeshPacket.h"

#include <algorithm>
#include <bit>

namespace osgTerrainROAM
{

namespace
{

constexpr std::uint32_t kMaxVertexGap = 8; ///< 256 B bridged: about what another upload call costs
constexpr std::uint32_t kMaxTriangleGap = 21;
constexpr std::uint32_t kLeastCapacity = 4096;

void copyRanges(const core::RoamMesh& mesh, MeshPacket& packet)
{
    for (const core::IndexRange& range : packet.vertexRanges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            packet.vertices.push_back(mesh.vertex(slot));
    for (const core::TriangleRange& range : packet.triangleRanges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            packet.triangles.push_back(mesh.triangle(slot));
}

MeshPacket emptyPacket(const core::RoamMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet;
    packet.serial = serial;
    packet.vertexCount = mesh.vertexSlots();
    packet.triangleCount = mesh.triangleSlots();
    return packet;
}

} // namespace

std::uint32_t bufferCapacity(std::uint32_t count)
{
    return std::max(kLeastCapacity, std::bit_ceil(count));
}

PacketPtr changedPacket(const core::RoamMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet = emptyPacket(mesh, serial);
    packet.vertexRanges = core::joinedRanges(mesh.changes().vertices, kMaxVertexGap);
    packet.triangleRanges = core::joinedRanges(mesh.changes().triangles, kMaxTriangleGap);
    copyRanges(mesh, packet);
    return std::make_shared<const MeshPacket>(std::move(packet));
}

PacketPtr wholePacket(const core::RoamMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet = emptyPacket(mesh, serial);
    packet.whole = true;
    packet.vertexRanges = {{0, packet.vertexCount}};
    const core::LeafArena& leaves = mesh.tree().leaves();
    for (std::uint32_t region = 0; region < leaves.regionCount(); ++region)
        if (leaves.region(region).count > 0) packet.triangleRanges.push_back(leaves.region(region));
    copyRanges(mesh, packet);
    return std::make_shared<const MeshPacket>(std::move(packet));
}

} // namespace osgTerrainROAM
