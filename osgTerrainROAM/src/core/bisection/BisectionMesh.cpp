// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTerrainROAM/core/bisection/BisectionMesh.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Which sides of a triangle lie on the border of the carrier.
struct BorderSides
{
    bool base = true, left = true, right = true;
};

/// Splits what is needed for a triangle to be there.
void reach(BisectionTree& tree, Bisector t)
{
    if (tree.isThere(t)) return;
    reach(tree, t.parent());
    tree.forceSplit(t.parent());
}

/// Splits all triangles whose base lies on the border of a carrier, down to the last level.
void splitBorder(BisectionTree& tree, Bisector t, BorderSides on = {})
{
    if (t.level() >= tree.levels() || !(on.base || on.left || on.right)) return;
    if (on.base && !tree.isSplit(t)) tree.forceSplit(t);
    if (!on.base && t.level() + 1 >= tree.levels()) return;
    if (!tree.isSplit(t)) tree.forceSplit(t); // a leg is the base of a half
    splitBorder(tree, t.half(0), {on.left, false, on.base});
    splitBorder(tree, t.half(1), {on.right, on.base, false});
}

} // namespace

BisectionMesh::BisectionMesh(const BisectionSurface& surface, std::span<const BisectionPatch> patches,
                             std::shared_ptr<const BisectionBounds> bounds)
    : _surface(surface),
      _patches(patches),
      _carriers(patches),
      _bounds(std::move(bounds)),
      _tree(surface.mesh(), surface.levels()),
      _isPatchActive(patches.size(), false),
      _needed(surface.vertices(), 0)
{
    std::uint32_t next = surface.vertices();
    for (const BisectionPatch& patch : patches)
    {
        _firstInside.push_back(next);
        next += static_cast<std::uint32_t>(patch.points.size() - patch.border.size());
    }
    findNeeds();
}

/// Splits for each patch what its border depends on, and the borders of those patches whose carriers are
/// split by that, too.
void BisectionMesh::findNeeds()
{
    for (std::uint32_t p = 0; p < _patches.size(); ++p)
    {
        BisectionTree tree(_surface.mesh(), _surface.levels());
        std::vector<bool> isForced(_patches.size(), false);
        for (std::uint32_t next = p; next < _patches.size();)
        {
            isForced[next] = true;
            reach(tree, _patches[next].carrier);
            splitBorder(tree, _patches[next].carrier);
            for (next = 0; next < _patches.size(); ++next)
                if (!isForced[next] && tree.isSplit(_patches[next].carrier)) break;
        }
        std::vector<std::uint32_t>& needs = _needs.emplace_back();
        for (std::uint32_t side = 0; side < _surface.mesh().sides(); ++side)
            _surface.visitWeighted(neighboursOf(_surface.mesh(), {side, 1}), kOwnCorners,
                                   [&](const BisectorNeighbours& at, std::uint32_t vertex, const auto&)
                                   {
                                       if (tree.isSplit(at.self)) needs.push_back(vertex);
                                       return tree.isSplit(at.self);
                                   });
        std::ranges::sort(needs);
        needs.erase(std::unique(needs.begin(), needs.end()), needs.end());
    }
}

BisectionChanges BisectionMesh::refine(const BisectionView& view)
{
    for (std::uint32_t p = 0; p < _patches.size(); ++p)
    {
        const bool isActive = _bounds->isActive(_surface.vertexOf(_patches[p].carrier), view);
        if (isActive == _isPatchActive[p]) continue;
        _isPatchActive[p] = isActive;
        for (const std::uint32_t vertex : _needs[p])
            _needed[vertex] = static_cast<std::uint16_t>(_needed[vertex] + (isActive ? 1 : -1));
    }
    BisectionChanges changes;
    for (std::uint32_t side = 0; side < _surface.mesh().sides(); ++side)
        follow(neighboursOf(_surface.mesh(), {side, 1}), view, changes);
    return changes;
}

void BisectionMesh::follow(const BisectorNeighbours& at, const BisectionView& view, BisectionChanges& changes)
{
    if (at.self.level() >= _tree.levels()) return;
    const std::uint32_t vertex = _surface.vertexOf(at);
    const bool isSplit = _tree.isSplit(at.self);
    if (_needed[vertex] == 0 && !_bounds->isActive(vertex, view))
    {
        if (isSplit) changes.merged += _tree.enhMerge(at.self);
        return;
    }
    if (!isSplit) changes.split += _tree.forceSplit(at.self);
    follow(at.half(0), view, changes);
    follow(at.half(1), view, changes);
}

std::vector<DrawnBisector> BisectionMesh::drawn() const
{
    std::vector<DrawnBisector> drawn;
    for (std::uint32_t side = 0; side < _surface.mesh().sides(); ++side)
        collect(neighboursOf(_surface.mesh(), {side, 1}), _surface.rootCorners(side), drawn);
    return drawn;
}

void BisectionMesh::collect(const BisectorNeighbours& at, const CornerVertices& corners,
                            std::vector<DrawnBisector>& drawn) const
{
    if (!_tree.isSplit(at.self)) return drawn.push_back({corners, at.self});
    if (const std::uint32_t patch = _carriers.at(at.self); patch != kNoSide) return addPatch(patch, drawn);
    const std::uint32_t middle = _surface.vertexOf(at);
    collect(at.half(0), {corners[2], corners[0], middle}, drawn);
    collect(at.half(1), {corners[1], corners[2], middle}, drawn);
}

void BisectionMesh::addPatch(std::uint32_t number, std::vector<DrawnBisector>& drawn) const
{
    const BisectionPatch& patch = _patches[number];
    const auto onBorder = static_cast<std::uint32_t>(patch.border.size());
    for (const CornerVertices& t : patch.triangles)
    {
        DrawnBisector triangle{{}, patch.carrier, number};
        for (std::size_t c = 0; c < 3; ++c)
            triangle.vertices[c] =
                t[c] < onBorder ? patch.border[t[c]] : _firstInside[number] + t[c] - onBorder;
        drawn.push_back(triangle);
    }
}

const glm::dvec3& BisectionMesh::point(std::uint32_t vertex) const
{
    if (vertex < _surface.vertices()) return _surface.point(vertex);
    const auto above = std::ranges::upper_bound(_firstInside, vertex);
    const auto patch = static_cast<std::size_t>(above - _firstInside.begin() - 1);
    return _patches[patch].points[_patches[patch].border.size() + vertex - _firstInside[patch]].point;
}

} // namespace osgTerrainROAM::core
