// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>

#include <foundation/PlainBytes.h>

#include <osgRoads/core/surface/RoadMeshBytes.h>

namespace osgRoads::core
{

namespace
{

using foundation::appendValue;
using foundation::appendValues;
using foundation::ValueTaker;

void appendChunk(std::string& bytes, const RoadChunk& chunk)
{
    appendValue(bytes, chunk.road);
    appendValue(bytes, chunk.sStart);
    appendValue(bytes, chunk.sEnd);
    appendValue(bytes, chunk.centre);
    appendValue(bytes, chunk.radius);
    appendValue(bytes, chunk.firstVertex);
    appendValue(bytes, chunk.vertexCount);
    appendValue(bytes, static_cast<std::uint64_t>(chunk.levels.size()));
    for (const ChunkLevel& level : chunk.levels)
    {
        appendValue(bytes, level.firstIndex);
        appendValue(bytes, level.indexCount);
        appendValue(bytes, level.errorM);
        appendValue(bytes, level.pavedCount);
    }
}

bool takeChunk(ValueTaker& taker, RoadChunk& chunk)
{
    constexpr std::size_t kLevelBytes = 3 * sizeof(std::uint32_t) + sizeof(double);
    std::uint64_t levels = 0;
    if (!taker.take(chunk.road) || !taker.take(chunk.sStart) || !taker.take(chunk.sEnd) ||
        !taker.take(chunk.centre) || !taker.take(chunk.radius) || !taker.take(chunk.firstVertex) ||
        !taker.take(chunk.vertexCount) || !taker.takeCount(levels, kLevelBytes))
        return false;
    chunk.levels.resize(static_cast<std::size_t>(levels));
    for (ChunkLevel& level : chunk.levels)
        if (!taker.take(level.firstIndex) || !taker.take(level.indexCount) || !taker.take(level.errorM) ||
            !taker.take(level.pavedCount))
            return false;
    return true;
}

/// Whether a range of so many numbers lies within all.
bool isWithin(std::uint64_t first, std::uint64_t count, std::size_t all)
{
    return first <= all && count <= all - first;
}

bool isChunkOf(const RoadMesh& mesh, const RoadChunk& chunk)
{
    if (!isWithin(chunk.firstVertex, chunk.vertexCount, mesh.vertices.size())) return false;
    return std::all_of(chunk.levels.begin(), chunk.levels.end(),
                       [&](const ChunkLevel& level)
                       {
                           return isWithin(level.firstIndex, level.indexCount, mesh.indices.size()) &&
                                  level.pavedCount <= level.indexCount;
                       });
}

bool canBeDrawn(const RoadMesh& mesh)
{
    const std::size_t vertices = mesh.vertices.size(), marks = mesh.marks.size(), decals = mesh.decals.size();
    return std::all_of(mesh.indices.begin(), mesh.indices.end(),
                       [&](std::uint32_t index) { return index < vertices; }) &&
           std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](const MeshVertex& vertex)
                       {
                           return vertex.kind <= SurfaceKind::skirt && vertex.rightRow < marks &&
                                  vertex.leftRow < marks && vertex.decalRow < decals;
                       }) &&
           std::all_of(mesh.chunks.begin(), mesh.chunks.end(),
                       [&](const RoadChunk& chunk) { return isChunkOf(mesh, chunk); });
}

} // namespace

std::string bytesOf(const RoadMesh& mesh)
{
    std::string bytes;
    bytes.reserve(mesh.vertices.size() * sizeof(MeshVertex) + mesh.indices.size() * sizeof(std::uint32_t) +
                  mesh.chunks.size() * 2 * sizeof(RoadChunk));
    appendValue(bytes, mesh.origin);
    appendValues(bytes, mesh.vertices);
    appendValues(bytes, mesh.indices);
    appendValues(bytes, mesh.marks);
    appendValues(bytes, mesh.unreached);
    appendValues(bytes, mesh.decals);
    appendValue(bytes, static_cast<std::uint64_t>(mesh.chunks.size()));
    for (const RoadChunk& chunk : mesh.chunks)
        appendChunk(bytes, chunk);
    return bytes;
}

std::optional<RoadMesh> roadMeshIn(std::string_view bytes)
{
    RoadMesh mesh;
    ValueTaker taker(bytes);
    std::uint64_t chunks = 0;
    if (!taker.take(mesh.origin) || !taker.take(mesh.vertices) || !taker.take(mesh.indices) ||
        !taker.take(mesh.marks) || !taker.take(mesh.unreached) || !taker.take(mesh.decals) ||
        !taker.takeCount(chunks, sizeof(std::uint64_t)))
        return std::nullopt;
    mesh.chunks.resize(static_cast<std::size_t>(chunks));
    for (RoadChunk& chunk : mesh.chunks)
        if (!takeChunk(taker, chunk)) return std::nullopt;
    return taker.isEmpty() && canBeDrawn(mesh) ? std::optional(std::move(mesh)) : std::nullopt;
}

} // namespace osgRoads::core
