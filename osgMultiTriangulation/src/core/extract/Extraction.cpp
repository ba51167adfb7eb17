// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <unordered_map>

#include <osgMultiTriangulation/core/extract/Extraction.h>

namespace osgMultiTriangulation::core
{

Extraction::Extraction(const ForestTree& main)
{
    _trees.emplace_back();
    _trees[0].source = &main;
    _trees[0].isApplied.assign(main.part.fragments.size(), false);
    _trees[0].slots.assign(main.part.triangleCount(), kNone);
    for (std::uint32_t t = 0; t < main.part.rootTriangles; ++t)
        activate({0, t});
}

void Extraction::attach(std::uint32_t number, const ForestTree& tree)
{
    assert(isAttached(tree.parent) && !isAttached(number));
    if (_trees.size() <= number) _trees.resize(number + 1);
    Tree& own = _trees[number];
    own.source = &tree;
    own.isApplied.assign(tree.part.fragments.size(), false);
    own.slots.assign(tree.part.triangleCount(), kNone);
    Tree& parent = _trees[tree.parent];
    parent.below.resize(parent.slots.size());
    for (std::uint32_t t = 0; t < tree.part.rootTriangles; ++t)
    {
        const InTree above{tree.parent, tree.parentTriangles[t]};
        const bool wasActive = isActive(above);
        if (wasActive) deactivate(above);
        parent.below[above.number] = {number, t};
        if (wasActive) activate({number, t});
    }
}

void Extraction::detach(std::uint32_t number)
{
    assert(number != 0 && isAttached(number));
    const ForestTree& tree = *_trees[number].source;
    for (auto f = static_cast<std::uint32_t>(tree.part.fragments.size()); f-- > 0;)
        if (_trees[number].isApplied[f]) takeBackAll({number, f});
    for (std::uint32_t t = 0; t < tree.part.rootTriangles; ++t)
    {
        const InTree above{tree.parent, tree.parentTriangles[t]};
        const bool wasActive = isActive({number, t});
        if (wasActive) deactivate({number, t});
        _trees[above.tree].below[above.number] = {};
        if (wasActive) activate(above);
    }
    _trees[number] = {};
}

void Extraction::extend(std::uint32_t number)
{
    Tree& own = _trees[number];
    own.isApplied.resize(own.source->part.fragments.size(), false);
    own.slots.resize(own.source->part.triangleCount(), kNone);
}

void Extraction::truncate(std::uint32_t number, std::size_t fragments)
{
    Tree& own = _trees[number];
    for (std::size_t f = own.isApplied.size(); f-- > fragments;)
        if (own.isApplied[f]) takeBackAll({number, static_cast<std::uint32_t>(f)});
    const MultiTriangulation& part = own.source->part;
    if (fragments < part.fragments.size()) own.slots.resize(part.fragments[fragments].firstTriangle);
    own.slots.shrink_to_fit();
    own.isApplied.resize(std::min(fragments, own.isApplied.size()));
    own.below = {};
}

/// Returns a triangle as the root of the lowest tree that has it.
InTree Extraction::resolved(InTree triangle) const
{
    while (!_trees[triangle.tree].below.empty())
    {
        const InTree below = _trees[triangle.tree].below[triangle.number];
        if (below.tree == kNone) break;
        triangle = below;
    }
    return triangle;
}

/// Returns the fragment whose star has a triangle; its tree is kNone when the triangle is part of the root of
/// all.
InTree Extraction::upperOf(InTree triangle) const
{
    while (triangle.tree != kNone)
    {
        const ForestTree& tree = *_trees[triangle.tree].source;
        if (triangle.number >= tree.part.rootTriangles)
            return {triangle.tree, tree.part.upper[triangle.number]};
        if (tree.parent == kNone) break;
        triangle = {tree.parent, tree.parentTriangles[triangle.number]};
    }
    return {};
}

bool Extraction::canTakeBack(const InTree& fragment) const
{
    if (!_trees[fragment.tree].isApplied[fragment.number]) return false;
    const Fragment& own = part(fragment.tree).fragments[fragment.number];
    for (std::uint32_t t = 0; t < own.triangleCount; ++t)
        if (!isActive(resolved({fragment.tree, own.firstTriangle + t}))) return false;
    return true;
}

/// Applies a fragment, after all on which it depends.
void Extraction::force(InTree fragment)
{
    _forced.assign(1, fragment);
    while (!_forced.empty())
    {
        const InTree next = _forced.back();
        if (_trees[next.tree].isApplied[next.number])
        {
            _forced.pop_back();
            continue;
        }
        const std::size_t waiting = _forced.size();
        for (const std::uint32_t floor : part(next.tree).floorOf(next.number))
        {
            const InTree upper = upperOf({next.tree, floor});
            if (upper.tree != kNone && !_trees[upper.tree].isApplied[upper.number]) _forced.push_back(upper);
        }
        if (_forced.size() > waiting) continue;
        apply(next);
        _forced.pop_back();
    }
}

void Extraction::apply(const InTree& fragment)
{
    const MultiTriangulation& own = part(fragment.tree);
    for (const std::uint32_t floor : own.floorOf(fragment.number))
        deactivate({fragment.tree, floor});
    const Fragment& star = own.fragments[fragment.number];
    for (std::uint32_t t = 0; t < star.triangleCount; ++t)
    {
        const InTree added = resolved({fragment.tree, star.firstTriangle + t});
        activate(added);
        _work.push_back(added);
    }
    _trees[fragment.tree].isApplied[fragment.number] = true;
    ++_changes;
}

void Extraction::takeBack(const InTree& fragment)
{
    const MultiTriangulation& own = part(fragment.tree);
    const Fragment& star = own.fragments[fragment.number];
    for (std::uint32_t t = 0; t < star.triangleCount; ++t)
        deactivate(resolved({fragment.tree, star.firstTriangle + t}));
    for (const std::uint32_t floor : own.floorOf(fragment.number))
    {
        activate({fragment.tree, floor});
        _work.push_back({fragment.tree, floor});
    }
    _trees[fragment.tree].isApplied[fragment.number] = false;
    ++_changes;
}

/// Takes back a fragment of a tree that is left; those that lie on its star have been taken back before.
void Extraction::takeBackAll(const InTree& fragment)
{
    assert(canTakeBack(fragment));
    takeBack(fragment);
    _work.clear();
}

void Extraction::activate(const InTree& triangle)
{
    _trees[triangle.tree].slots[triangle.number] = static_cast<std::uint32_t>(_active.size());
    _active.push_back(triangle);
}

void Extraction::deactivate(const InTree& triangle)
{
    std::uint32_t& slot = _trees[triangle.tree].slots[triangle.number];
    assert(slot != kNone);
    const InTree last = _active.back();
    _active[slot] = last;
    _trees[last.tree].slots[last.number] = slot;
    slot = kNone;
    _active.pop_back();
}

SurfaceMesh Extraction::mesh() const
{
    SurfaceMesh mesh;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers; // by place in the plan
    mesh.triangles.reserve(_active.size());
    for (const InTree& at : _active)
    {
        Triangle triangle{};
        for (int c = 0; c < 3; ++c)
        {
            const SurfacePoint& p = part(at.tree).points[part(at.tree).corners[at.number][c]];
            const std::uint64_t place = std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y);
            const auto [found, isNew] =
                numbers.try_emplace(place, static_cast<std::uint32_t>(mesh.points.size()));
            if (isNew) mesh.points.push_back(p);
            triangle[c] = found->second;
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

} // namespace osgMultiTriangulation::core
