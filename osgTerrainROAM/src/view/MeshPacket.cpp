// SPDX-License-Identifier: Apache-2.0
#include "MeshPacket.h"

#include <algorithm>
#include <bit>

namespace osgTerrainROAM
{

namespace
{

constexpr std::uint32_t kMaxVertexGap = 16; ///< 256 B bridged: about what another upload call costs
constexpr std::uint32_t kMaxTriangleGap = 21;
constexpr std::uint32_t kLeastCapacity = 4096;

void copyRanges(const core::TerrainMesh& mesh, MeshPacket& packet)
{
    for (const core::IndexRange& range : packet.vertexRanges)
        mesh.appendVertices(range, packet.vertices);
    for (const core::IndexRange& range : packet.triangleRanges)
        mesh.appendTriangles(range, packet.triangles);
}

MeshPacket emptyPacket(const core::TerrainMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet;
    packet.serial = serial;
    packet.patchExponent = mesh.patches() ? mesh.patches()->shape().exponent : 0;
    packet.vertexCount = mesh.vertexSlots();
    packet.triangleCount = mesh.triangleSlots();
    return packet;
}

/// A packet with the patches of some slots: their vertices one patch after the other.
MeshPacket patchPacket(const core::TerrainMesh& mesh, std::uint64_t serial, std::vector<std::uint32_t> slots)
{
    MeshPacket packet = emptyPacket(mesh, serial);
    const core::PatchPool& patches = *mesh.patches();
    const core::PatchShape& shape = patches.shape();
    const auto perPatch = static_cast<std::uint32_t>(shape.vertices.size());
    packet.vertexCount = patches.slotCount() * perPatch;
    packet.triangleCount = static_cast<std::uint32_t>(shape.triangles.size());
    packet.vertexRanges = core::joinedRanges(std::move(slots), 0);
    for (core::IndexRange& range : packet.vertexRanges)
    {
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            mesh.appendPatch(slot, packet.vertices);
        range = {range.first * perPatch, range.count * perPatch};
    }
    return packet;
}

MeshPacket wholePatchPacket(const core::TerrainMesh& mesh, std::uint64_t serial)
{
    const core::PatchPool& patches = *mesh.patches();
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < patches.slotCount(); ++slot)
        if (patches.leaf(slot).exists()) slots.push_back(slot);
    MeshPacket packet = patchPacket(mesh, serial, std::move(slots));
    packet.triangleRanges = {{0, packet.triangleCount}};
    for (const core::PatchShape::Triangle& t : patches.shape().triangles)
        packet.triangles.push_back({{t[0], t[1], t[2]}});
    return packet;
}

MeshPacket wholeTrianglePacket(const core::TerrainMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet = emptyPacket(mesh, serial);
    packet.vertexRanges = {{0, packet.vertexCount}};
    packet.triangleRanges = mesh.allRanges();
    copyRanges(mesh, packet);
    return packet;
}

} // namespace

std::uint32_t bufferCapacity(std::uint32_t count)
{
    return std::max(kLeastCapacity, std::bit_ceil(count));
}

PacketPtr changedPacket(const core::TerrainMesh& mesh, std::uint64_t serial)
{
    if (mesh.patches())
        return std::make_shared<const MeshPacket>(patchPacket(mesh, serial, mesh.patches()->written()));
    MeshPacket packet = emptyPacket(mesh, serial);
    packet.vertexRanges = core::joinedRanges(mesh.changes().vertices, kMaxVertexGap);
    packet.triangleRanges = core::joinedRanges(mesh.changes().triangles, kMaxTriangleGap);
    copyRanges(mesh, packet);
    return std::make_shared<const MeshPacket>(std::move(packet));
}

PacketPtr wholePacket(const core::TerrainMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet = mesh.patches() ? wholePatchPacket(mesh, serial) : wholeTrianglePacket(mesh, serial);
    packet.whole = true;
    return std::make_shared<const MeshPacket>(std::move(packet));
}

} // namespace osgTerrainROAM
