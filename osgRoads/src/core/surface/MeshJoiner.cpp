// SPDX-License-Identifier: Apache-2.0
#include "MeshJoiner.h"

#include <algorithm>
#include <utility>

namespace osgRoads::core
{

namespace
{

/// Appends all rows of a part but the empty first one. Returns what its numbers of rows grow by.
template<class Row>
std::uint32_t appendRows(const std::vector<Row>& rows, std::vector<Row>& to)
{
    const auto grow = static_cast<std::uint32_t>(to.size() - 1);
    if (!rows.empty()) to.insert(to.end(), rows.begin() + 1, rows.end());
    return grow;
}

void append(RoadMesh part, RoadMesh& to)
{
    const auto vertices = static_cast<std::uint32_t>(to.vertices.size()),
               indices = static_cast<std::uint32_t>(to.indices.size());
    const std::uint32_t marks = appendRows(part.marks, to.marks), decals = appendRows(part.decals, to.decals);
    const auto moved = [](std::uint32_t row, std::uint32_t by) { return row == 0 ? 0 : row + by; };
    for (MeshVertex vertex : part.vertices)
    {
        vertex.rightRow = moved(vertex.rightRow, marks);
        vertex.leftRow = moved(vertex.leftRow, marks);
        vertex.decalRow = moved(vertex.decalRow, decals);
        to.vertices.push_back(vertex);
    }
    for (const std::uint32_t index : part.indices)
        to.indices.push_back(index + vertices);
    to.unreached.insert(to.unreached.end(), part.unreached.begin(), part.unreached.end());
    for (RoadChunk& chunk : part.chunks)
    {
        chunk.firstVertex += vertices;
        for (ChunkLevel& level : chunk.levels)
            level.firstIndex += indices;
        to.chunks.push_back(std::move(chunk));
    }
}

} // namespace

MeshJoiner::MeshJoiner(const glm::dvec3& origin, std::size_t parts) : _parts(parts)
{
    _mesh.origin = origin;
    _mesh.marks.resize(1);
    _mesh.decals.resize(1);
}

/// Reserves room for all parts as soon as that for the next one is missing: growing by doubling would hold
/// the mesh twice.
void MeshJoiner::makeRoomFor(const RoadMesh& part)
{
    constexpr double kMore = 1.25;
    const auto reserve = [&](auto& all, const auto& next)
    {
        const std::size_t needed = all.size() + next.size();
        if (all.capacity() >= needed) return;
        const double share = static_cast<double>(_parts) / static_cast<double>(_added + 1);
        all.reserve(std::max(needed, static_cast<std::size_t>(kMore * share * static_cast<double>(needed))));
    };
    reserve(_mesh.vertices, part.vertices);
    reserve(_mesh.indices, part.indices);
}

void MeshJoiner::add(RoadMesh part)
{
    if (_parts == 1)
        _mesh = std::move(part);
    else
    {
        makeRoomFor(part);
        append(std::move(part), _mesh);
    }
    ++_added;
}

} // namespace osgRoads::core
