// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <utility>

#include <osgTerrainROAM/core/blocks/BlockMesh.h>
#include <osgTerrainROAM/core/roam/NearestSurface.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Blocks with their distance from a point, nearest first.
std::vector<std::pair<double, std::uint32_t>> byDistance(std::uint32_t count, const auto& distanceOf)
{
    std::vector<std::pair<double, std::uint32_t>> order;
    for (std::uint32_t block = 0; block < count; ++block)
        order.emplace_back(distanceOf(block), block);
    std::sort(order.begin(), order.end());
    return order;
}

void noteRange(IndexRange range, std::vector<std::uint32_t>& slots)
{
    const std::size_t before = slots.size();
    slots.resize(before + range.count);
    std::iota(slots.begin() + static_cast<std::ptrdiff_t>(before), slots.end(), range.first);
}

/// Gives a run another size where it has to have one.
void resize(IndexRange& run, std::uint32_t count, BlockSlots& slots)
{
    if (run.count == count) return;
    if (run.count > 0) slots.give(run);
    run = {slots.take(count), count};
}

} // namespace

void BlockMesh::appendVertices(IndexRange slots, std::vector<MeshVertex>& vertices) const
{
    const auto first = _vertices.begin() + slots.first;
    vertices.insert(vertices.end(), first, first + slots.count);
}

void BlockMesh::appendTriangles(IndexRange slots, std::vector<LeafTriangle>& triangles) const
{
    const auto first = _triangles.begin() + slots.first;
    triangles.insert(triangles.end(), first, first + slots.count);
}

void BlockMesh::append(std::uint32_t block, std::vector<IndexRange>& ranges) const
{
    const Run& run = _runs[block];
    if (run.triangleCount > 0) ranges.push_back({run.triangles.first, run.triangleCount});
}

std::uint32_t BlockMesh::visibleRanges(const viewlod::Frustum& frustum, std::vector<IndexRange>& ranges) const
{
    std::uint32_t triangles = 0;
    for (std::uint32_t block = 0; block < _grid.count(); ++block)
    {
        if (!box(block).mayBeSeen(frustum)) continue;
        append(block, ranges);
        triangles += _runs[block].triangleCount;
    }
    return triangles;
}

std::uint32_t BlockMesh::visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3& eye, const Horizon*,
                                       std::vector<IndexRange>& ranges) const
{
    std::uint32_t triangles = 0;
    for (const auto& [distance, block] :
         byDistance(_grid.count(), [&](std::uint32_t b) { return glm::distance(box(b).centre(), eye); }))
    {
        if (!box(block).mayBeSeen(frustum)) continue;
        append(block, ranges);
        triangles += _runs[block].triangleCount;
    }
    return triangles;
}

DrawnMesh BlockMesh::drawn(std::span<const IndexRange> ranges) const
{
    DrawnMesh mesh{_vertices, _places, {}, _stepM, _isMorphed};
    for (const Run& run : _runs)
    {
        if (run.sunk == 0) continue;
        mesh.sunk.resize(_vertices.size());
        std::fill_n(mesh.sunk.begin() + run.vertices.first, run.sunk, true);
    }
    for (const IndexRange& range : ranges)
        appendTriangles(range, mesh.triangles);
    return mesh;
}

double BlockMesh::nearestM(std::uint32_t block, const glm::dvec3& point) const
{
    double leastM = std::numeric_limits<double>::infinity();
    const Run& run = _runs[block];
    for (std::uint32_t i = 0; i < run.triangleCount; ++i)
    {
        const LeafTriangle& t = _triangles[run.triangles.first + i];
        const auto corner = [&](std::size_t k) { return positionOf(_vertices[t.vertices[k]], _stepM); };
        leastM = std::min(leastM, distanceToTriangleM(point, {corner(0), corner(1), corner(2)}));
    }
    return leastM;
}

double BlockMesh::nearestM(const glm::dvec3& point) const
{
    double leastM = std::numeric_limits<double>::infinity();
    for (const auto& [distance, block] :
         byDistance(_grid.count(), [&](std::uint32_t b) { return box(b).distanceM(point); }))
    {
        if (distance >= leastM) break;
        leastM = std::min(leastM, nearestM(block, point));
    }
    return leastM;
}

void BlockMesh::forEachTriangleAtBorder(const BorderVisit& visit) const
{
    for (std::uint32_t block = 0; block < _grid.count(); ++block)
    {
        bool isAtBorder = false;
        for (int side = 0; side < kSides; ++side)
            isAtBorder = isAtBorder || _grid.neighbour(block, side) == kNone;
        const Run& run = _runs[block];
        for (std::uint32_t i = 0; isAtBorder && i < run.triangleCount - run.ofRim; ++i)
        {
            const LeafTriangle& t = _triangles[run.triangles.first + i];
            visit({_places[t.vertices[0]], _places[t.vertices[1]], _places[t.vertices[2]]}, t);
        }
    }
}

bool BlockMesh::isValid() const
{
    std::uint32_t triangles = 0;
    for (const Run& run : _runs)
    {
        triangles += run.triangleCount;
        for (std::uint32_t i = 0; i < run.triangleCount; ++i)
        {
            const LeafTriangle& t = _triangles[run.triangles.first + i];
            for (const std::uint32_t v : t.vertices)
                if (v < run.vertices.first || v >= run.vertices.first + run.vertices.count) return false;
            const PlanTriangle plan{{_places[t.vertices[0]], _places[t.vertices[1]], _places[t.vertices[2]]}};
            if (plan.doubleArea() <= 0) return false;
        }
    }
    return triangles == _triangleCount;
}

std::size_t BlockMesh::memoryBytes() const
{
    return _vertices.capacity() * (sizeof(MeshVertex) + sizeof(GridPoint)) +
           _triangles.capacity() * sizeof(LeafTriangle) + _runs.capacity() * sizeof(Run);
}

void BlockMesh::writeVertices(std::uint32_t block, std::span<const Vertex> vertices, std::uint32_t capacity,
                              std::uint32_t sunk)
{
    _runs[block].sunk = sunk;
    IndexRange& run = _runs[block].vertices;
    resize(run, capacity, _vertexSlots);
    _vertices.resize(_vertexSlots.slotCount());
    _places.resize(_vertexSlots.slotCount());
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        _vertices[run.first + i] = meshVertex(vertices[i].position, vertices[i].place, _stepM);
        _places[run.first + i] = vertices[i].place;
    }
    noteRange({run.first, static_cast<std::uint32_t>(vertices.size())}, _changes.vertices);
}

void BlockMesh::writeTriangles(std::uint32_t block, std::span<const LeafTriangle> triangles,
                               std::uint32_t capacity, std::uint32_t ofRim)
{
    Run& run = _runs[block];
    run.ofRim = ofRim;
    resize(run.triangles, capacity, _triangleSlots);
    _triangles.resize(_triangleSlots.slotCount());
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
        LeafTriangle& t = _triangles[run.triangles.first + i];
        for (std::size_t k = 0; k < 3; ++k)
            t.vertices[k] = triangles[i].vertices[k] + run.vertices.first;
    }
    const auto count = static_cast<std::uint32_t>(triangles.size());
    _triangleCount += count - run.triangleCount;
    run.triangleCount = count;
    noteRange({run.triangles.first, count}, _changes.triangles);
}

} // namespace osgTerrainROAM::core
