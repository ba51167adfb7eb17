// SPDX-License-Identifier: Apache-2.0
// The drawn part of a RoamMesh: by regions of the tree, then, with patches, patch by patch.
#include <algorithm>

#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/NearestSurface.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Sorts by distance, nearest first; elements at equal distances keep their order.
template<class Elements, class CentreOf>
void sortByDistance(Elements&& elements, const glm::dvec3& eye, const CentreOf& centreOf)
{
    std::vector<std::pair<double, std::size_t>> keys;
    for (std::size_t i = 0; i < elements.size(); ++i)
        keys.emplace_back(glm::distance(centreOf(elements[i]), eye), i);
    std::sort(keys.begin(), keys.end());
    const std::vector before(elements.begin(), elements.end());
    for (std::size_t i = 0; i < keys.size(); ++i)
        elements[i] = before[keys[i].second];
}

} // namespace

std::optional<Horizon> RoamMesh::horizon(const glm::dvec3& eye) const
{
    if (!_eye || *_eye != eye || !tile().hidingGround.exists || !_sight.isEverything()) return std::nullopt;
    const auto ground = drawnGroundAt(_tree, eye.x, eye.y);
    if (!ground || ground->position.z >= eye.z) return std::nullopt;
    return Horizon::around(tile().tile, tile().hidingGround, eye, _errorPerM, _nearM);
}

std::uint32_t RoamMesh::visibleRanges(const viewlod::Frustum& frustum, std::vector<IndexRange>& ranges) const
{
    std::vector<std::uint32_t> regions;
    tile().regions.visible(frustum, nullptr, regions);
    return appendRanges(regions, frustum, ranges);
}

std::uint32_t RoamMesh::visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                      const Horizon* horizon, std::vector<IndexRange>& ranges) const
{
    std::vector<std::uint32_t> regions;
    tile().regions.visible(frustum, horizon, regions);
    sortByDistance(regions, eye, [this](std::uint32_t region) { return tile().regions.centre(region); });
    const auto first = static_cast<std::ptrdiff_t>(ranges.size());
    const std::uint32_t triangles = appendRanges(regions, frustum, ranges);
    if (_patches)
        sortByDistance(std::span(ranges).subspan(static_cast<std::size_t>(first)), eye,
                       [this](const IndexRange& patch) { return _patches->centre(patch.first); });
    return triangles;
}

std::uint32_t RoamMesh::appendRanges(const std::vector<std::uint32_t>& regions,
                                     const viewlod::Frustum& frustum, std::vector<IndexRange>& ranges) const
{
    const auto append = [&](std::uint32_t region) {
        return _patches ? appendPatches(region, frustum, ranges)
                        : _tree.leaves().appendRanges(region, ranges);
    };
    std::uint32_t triangles = append(0); // coarser than a region: few, and never worth a test
    for (const std::uint32_t region : regions)
        triangles += append(region + 1);
    return triangles;
}

std::uint32_t RoamMesh::appendPatches(std::uint32_t region, const viewlod::Frustum& frustum,
                                      std::vector<IndexRange>& ranges) const
{
    const std::size_t before = ranges.size();
    _tree.leaves().forEachLeaf(region,
                               [&](TriangleId leaf)
                               {
                                   const std::uint32_t slot = _patches->slotOf(leaf);
                                   if (_patches->mayBeSeen(slot, frustum)) ranges.push_back({slot, 1});
                               });
    return static_cast<std::uint32_t>(ranges.size() - before) << patchExponent();
}

void RoamMesh::appendVertices(IndexRange slots, std::vector<MeshVertex>& vertices) const
{
    for (std::uint32_t slot = slots.first; slot < slots.first + slots.count; ++slot)
        vertices.push_back(vertex(slot));
}

void RoamMesh::appendTriangles(IndexRange slots, std::vector<LeafTriangle>& triangles) const
{
    for (std::uint32_t slot = slots.first; slot < slots.first + slots.count; ++slot)
        triangles.push_back(triangle(slot));
}

void RoamMesh::appendPatch(std::uint32_t slot, std::vector<MeshVertex>& vertices) const
{
    _patches->shape().appendVertices(tile().tile, _tree.gridTriangle(_patches->leaf(slot)), vertices);
}

double RoamMesh::nearestM(const glm::dvec3& point) const
{
    return nearestSurfaceM(_tree, point);
}

DrawnMesh RoamMesh::drawn(std::span<const IndexRange> ranges) const
{
    DrawnMesh mesh;
    mesh.stepM = tile().tile.frame().vertexStepM();
    mesh.isMorphed = _isMorphing;
    for (VertexSlot v = 0; v < _tree.vertexSlots() && !_patches; ++v)
    {
        mesh.vertices.push_back(vertex(v));
        mesh.grid.push_back(_tree.place(v).point());
    }
    for (const IndexRange& range : ranges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            if (_patches)
                _patches->shape().append(tile().tile, _tree.gridTriangle(_patches->leaf(slot)), mesh);
            else if (_tree.leaves().leaf(slot).exists())
                mesh.triangles.push_back(triangle(slot));
    return mesh;
}

} // namespace osgTerrainROAM::core
