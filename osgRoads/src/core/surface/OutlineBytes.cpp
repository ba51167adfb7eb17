// SPDX-License-Identifier: Apache-2.0
#include "OutlineBytes.h"

#include <algorithm>

#include <foundation/PlainBytes.h>

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
bool isWithin(std::uint64_t first, std::uint64_t count, std::uint64_t all)
{
    return first <= all && count <= all - first;
}

bool isChunkOf(const MeshSize& size, const RoadChunk& chunk)
{
    if (!isWithin(chunk.firstVertex, chunk.vertexCount, size.vertices) || chunk.levels.empty()) return false;
    return std::all_of(chunk.levels.begin(), chunk.levels.end(),
                       [&](const ChunkLevel& level)
                       {
                           return isWithin(level.firstIndex, level.indexCount, size.indices) &&
                                  level.pavedCount <= level.indexCount;
                       });
}

} // namespace

void appendOutline(std::string& bytes, const RoadMesh& mesh)
{
    appendValue(bytes, mesh.origin);
    appendValue(bytes, MeshSize{static_cast<std::uint32_t>(mesh.vertices.size()),
                                static_cast<std::uint32_t>(mesh.indices.size())});
    appendValues(bytes, mesh.marks);
    appendValues(bytes, mesh.unreached);
    appendValues(bytes, mesh.decals);
    appendValue(bytes, static_cast<std::uint64_t>(mesh.chunks.size()));
    for (const RoadChunk& chunk : mesh.chunks)
        appendChunk(bytes, chunk);
}

bool takeOutline(ValueTaker& taker, RoadMesh& outline, MeshSize& size)
{
    std::uint64_t chunks = 0;
    if (!taker.take(outline.origin) || !taker.take(size) || !taker.take(outline.marks) ||
        !taker.take(outline.unreached) || !taker.take(outline.decals) ||
        !taker.takeCount(chunks, sizeof(std::uint64_t)))
        return false;
    outline.chunks.resize(static_cast<std::size_t>(chunks));
    return std::all_of(outline.chunks.begin(), outline.chunks.end(),
                       [&](RoadChunk& chunk) { return takeChunk(taker, chunk) && isChunkOf(size, chunk); });
}

} // namespace osgRoads::core
