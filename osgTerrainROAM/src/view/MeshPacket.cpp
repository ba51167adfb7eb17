// SPDX-License-Identifier: Apache-2.0
#include "MeshPacket.h"

#include <algorithm>
#include <bit>
#include <span>

namespace osgTerrainROAM
{

namespace
{

constexpr std::uint32_t kMaxVertexGap = 8; ///< 256 B bridged: about what another upload call costs
constexpr std::uint32_t kMaxTriangleGap = 21;
constexpr std::uint32_t kLeastCapacity = 4096;

template<class Element>
std::vector<Element> copiedRanges(std::span<const Element> source,
                                  const std::vector<core::IndexRange>& ranges)
{
    std::vector<Element> copy;
    for (const core::IndexRange& range : ranges)
        copy.insert(copy.end(), source.begin() + range.first, source.begin() + range.first + range.count);
    return copy;
}

MeshPacket emptyPacket(const core::RoamMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet;
    packet.serial = serial;
    packet.vertexCount = static_cast<std::uint32_t>(mesh.vertices().size());
    packet.triangleCount = static_cast<std::uint32_t>(mesh.triangles().size());
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
    packet.vertices = copiedRanges(mesh.vertices(), packet.vertexRanges);
    packet.triangleRanges = core::joinedRanges(mesh.changes().triangles, kMaxTriangleGap);
    packet.triangles = copiedRanges(mesh.triangles(), packet.triangleRanges);
    return std::make_shared<const MeshPacket>(std::move(packet));
}

PacketPtr wholePacket(const core::RoamMesh& mesh, std::uint64_t serial)
{
    MeshPacket packet = emptyPacket(mesh, serial);
    packet.whole = true;
    packet.vertexRanges = {{0, packet.vertexCount}};
    packet.vertices.assign(mesh.vertices().begin(), mesh.vertices().end());
    packet.triangleRanges = {{0, packet.triangleCount}};
    packet.triangles.assign(mesh.triangles().begin(), mesh.triangles().end());
    return std::make_shared<const MeshPacket>(std::move(packet));
}

} // namespace osgTerrainROAM
