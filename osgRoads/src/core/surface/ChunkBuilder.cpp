// SPDX-License-Identifier: Apache-2.0
#include "ChunkBuilder.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

ChunkBuilder::ChunkBuilder(const PlacedNetwork& network, int road, const LaneSection& section,
                           const OpenEnds& ends, const RoadMeshSettings& settings, MarkRows& marks,
                           DecalRows& decals, RoadMesh& mesh)
    : _network(network),
      _road(road),
      _shape(network.road(road), section, settings.bed),
      _cover(network, road),
      _mesh(mesh),
      _rows(network, road, section, _shape, _cover, settings),
      _strips(section, _shape, _cover, _rows, marks, decals),
      _vertices(network, road, section, ends, _shape, _cover, _rows, mesh),
      _triangles(_shape, _rows, mesh)
{
}

/// Whether all of the chunk lies where positions of the mesh can be counted.
bool ChunkBuilder::isWithinReach() const
{
    const auto isNear = [this](const glm::dvec3& place)
    { return glm::all(glm::lessThan(glm::abs(place - _mesh.origin), glm::dvec3(RoadMesh::kReachM))); };
    return std::all_of(_rows.rows().begin(), _rows.rows().end(),
                       [&](const ChunkRow& row)
                       { return std::all_of(row.places.begin(), row.places.end(), isNear); });
}

/// Returns a chunk without levels, whose sphere holds its rows.
RoadChunk ChunkBuilder::chunkOf(double from, double to, std::uint32_t firstVertex) const
{
    RoadChunk chunk;
    chunk.road = _road;
    chunk.sStart = from;
    chunk.sEnd = to;
    chunk.firstVertex = firstVertex;
    chunk.vertexCount = static_cast<std::uint32_t>(_mesh.vertices.size()) - firstVertex;
    glm::dvec3 least(1e300), most(-1e300);
    for (const ChunkRow& row : _rows.rows())
        for (const glm::dvec3& place : row.places)
        {
            least = glm::min(least, place);
            most = glm::max(most, place);
        }
    chunk.centre = 0.5 * (least + most);
    chunk.radius = 0.5 * glm::distance(least, most);
    return chunk;
}

void ChunkBuilder::add(double from, double to)
{
    _rows.sample(from, to);
    if (!isWithinReach())
    {
        if (_mesh.unreached.empty() || _mesh.unreached.back() != _road) _mesh.unreached.push_back(_road);
        return;
    }
    const RoadStructure* structure = structureAt(_network.road(_road), 0.5 * (from + to));
    const ChunkPlace place{from, structure == nullptr, structure && structure->kind == StructureKind::tunnel};
    const auto firstVertex = static_cast<std::uint32_t>(_mesh.vertices.size());
    const std::vector<MeshVertex> strips = _strips.stripsAt(from, place.hasGround);
    for (std::size_t i = 0; i < _rows.rows().size(); i += 2)
        _vertices.addRow(i, place, strips);
    RoadChunk chunk = chunkOf(from, to, firstVertex);
    _triangles.addLevels(chunk);
    chunk.radius += chunk.levels.front().errorM;
    _mesh.chunks.push_back(std::move(chunk));
}

} // namespace osgRoads::core
