// SPDX-License-Identifier: Apache-2.0
// Source: Kay & Kajiya, *Ray tracing complex scenes*, 1986 (median cut); Assarsson & Möller, *Optimized View
// Frustum Culling Algorithms for Bounding Boxes*, 2000.
#include <algorithm>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgRoads/core/surface/ChunkTree.h>

#include "ChunkLevels.h"

namespace osgRoads::core
{

/// What a search asks for and what it has found.
struct ChunkTree::Search
{
    const viewlod::ViewState& view;
    double farthestM;
    Visible found;

    /// Whether a sphere is seen; `toTest` becomes the planes that cross it.
    bool sees(const glm::dvec3& centre, double radius, viewlod::Frustum::Mask& toTest)
    {
        ++found.looks;
        if (!isNear(view, centre, radius, farthestM)) return false;
        const auto verdict = view.frustum.classify(centre, radius, toTest);
        toTest = verdict.crossing;
        return !verdict.outside;
    }
};

ChunkTree::ChunkTree(const RoadMesh& mesh) : _items(mesh.chunks.size())
{
    if (_items.empty()) return;
    std::iota(_items.begin(), _items.end(), 0u);
    build(mesh.chunks, 0, static_cast<std::uint32_t>(_items.size()));
    for (const std::uint32_t item : _items)
        _spheres.push_back({mesh.chunks[item].centre, mesh.chunks[item].radius});
}

void ChunkTree::build(const std::vector<RoadChunk>& chunks, std::uint32_t first, std::uint32_t count)
{
    const auto begin = _items.begin() + first;
    glm::dvec3 least(1e300), most(-1e300);
    for (auto item = begin; item != begin + count; ++item)
    {
        least = glm::min(least, chunks[*item].centre);
        most = glm::max(most, chunks[*item].centre);
    }
    Node node{0.5 * (least + most), 0.0, first, count, 0};
    for (auto item = begin; item != begin + count; ++item)
        node.radius =
            std::max(node.radius, glm::distance(node.centre, chunks[*item].centre) + chunks[*item].radius);
    const std::size_t own = _nodes.size();
    _nodes.push_back(node);
    if (count <= kLeafItems) return;
    const glm::dvec3 size = most - least;
    const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count,
                     [&](std::uint32_t a, std::uint32_t b)
                     {
                         const double left = chunks[a].centre[axis], right = chunks[b].centre[axis];
                         return left < right || (left == right && a < b);
                     });
    build(chunks, first, half);
    _nodes[own].second = static_cast<std::uint32_t>(_nodes.size());
    build(chunks, first + half, count - half);
}

void ChunkTree::search(std::uint32_t index, viewlod::Frustum::Mask toTest, Search& asked) const
{
    const Node& node = _nodes[index];
    if (!asked.sees(node.centre, node.radius, toTest)) return;
    if (node.second > 0)
    {
        search(index + 1, toTest, asked);
        search(node.second, toTest, asked);
        return;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
    {
        viewlod::Frustum::Mask planes = toTest;
        if (asked.sees(_spheres[i].centre, _spheres[i].radius, planes))
            asked.found.chunks.push_back(_items[i]);
    }
}

ChunkTree::Visible ChunkTree::visible(const viewlod::ViewState& view, double farthestM) const
{
    Search asked{view, farthestM, {}};
    if (!_nodes.empty()) search(0, viewlod::Frustum::kAllPlanes, asked);
    std::sort(asked.found.chunks.begin(), asked.found.chunks.end());
    return std::move(asked.found);
}

std::vector<ChunkChoice> chooseLevels(const RoadMesh& mesh, const ChunkTree& tree,
                                      const viewlod::ViewState& view, const RoadViewSettings& settings)
{
    std::vector<ChunkChoice> choices;
    const ChunkTree::Visible visible = tree.visible(view, settings.farthestM);
    for (const std::uint32_t chunk : visible.chunks)
        choices.push_back({chunk, coarsestLevel(mesh.chunks[chunk], view, settings)});
    return choices;
}

} // namespace osgRoads::core
