// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/structure/Forest.h>

namespace osgMultiTriangulation::core
{

/// A triangle or a fragment of a forest.
struct InTree
{
    std::uint32_t tree = kNone, number = kNone;

    bool operator==(const InTree&) const = default;
};

/// A triangulation of variable resolution, taken from the trees of a forest that are in memory. It starts at
/// the root; fragments are applied, those first on which they depend, until a criterion is met everywhere. It
/// is always a triangulation of the whole surface, across trees too: a fragment is applied only as a whole,
/// in place of its whole floor. A criterion is called as needsMore(tree's MultiTriangulation, triangle) and
/// tells whether a triangle is too coarse.
/// Memory: 5 B a triangle and 1 B a fragment of the trees in memory. Threads: one.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), sections 2
/// and 5.
class Extraction
{
public:
    /// `main`: the main part of a forest. It must live as long as this, as all trees that are attached.
    explicit Extraction(const ForestTree& main);

    /// Takes a tree in. Its parent must be attached, completely loaded.
    void attach(std::uint32_t number, const ForestTree& tree);

    /// Goes back to the root of a tree and leaves it. No child of it may be attached.
    void detach(std::uint32_t number);

    /// Follows a tree that has got more fragments since it was attached.
    void extend(std::uint32_t number);

    /// Takes back the fragments of a tree from `fragments` on, which will leave it. No child of it may be
    /// attached.
    void truncate(std::uint32_t number, std::size_t fragments);

    bool isAttached(std::uint32_t number) const
    {
        return number < _trees.size() && _trees[number].source != nullptr;
    }

    /// Refines until no triangle needs more or has more. What was finer stays.
    /// Cost: that of the criterion for all triangles, and of the fragments applied.
    template<class NeedsMore>
    void refine(const NeedsMore& needsMore)
    {
        _work = _active;
        while (!_work.empty())
        {
            const InTree at = _work.back();
            _work.pop_back();
            const std::uint32_t lower = part(at.tree).lower[at.number];
            if (lower != kNone && isActive(at) && needsMore(part(at.tree), at.number))
                force({at.tree, lower});
        }
    }

    /// Takes fragments back as long as no triangle of their floors needs more.
    /// Cost: that of the criterion for the floors of the fragments at the front.
    template<class NeedsMore>
    void coarsen(const NeedsMore& needsMore)
    {
        _work = _active;
        while (!_work.empty())
        {
            const InTree fragment = upperOf(_work.back());
            _work.pop_back();
            if (fragment.tree == kNone || !canTakeBack(fragment)) continue;
            const MultiTriangulation& own = part(fragment.tree);
            bool isNeeded = false;
            for (const std::uint32_t floor : own.floorOf(fragment.number))
                isNeeded = isNeeded || needsMore(own, floor);
            if (!isNeeded) takeBack(fragment);
        }
    }

    /// Follows a criterion that has changed: coarsens, then refines.
    template<class NeedsMore>
    void update(const NeedsMore& needsMore)
    {
        coarsen(needsMore);
        refine(needsMore);
    }

    /// The triangles of the current triangulation, in no order.
    std::span<const InTree> active() const { return _active; }
    const MultiTriangulation& part(std::uint32_t tree) const { return _trees[tree].source->part; }

    /// The number of fragments applied and taken back so far.
    std::uint64_t changes() const { return _changes; }

    /// Returns the current triangulation as a mesh; each point occurs once.
    SurfaceMesh mesh() const;

private:
    struct Tree
    {
        const ForestTree* source = nullptr;
        std::vector<bool> isApplied;      ///< by fragment
        std::vector<std::uint32_t> slots; ///< by triangle: its place in _active, or kNone
        std::vector<InTree> below;        ///< by triangle: itself as root of a child; empty without children
    };

    InTree resolved(InTree triangle) const;
    InTree upperOf(InTree triangle) const;
    bool isActive(const InTree& triangle) const
    {
        return _trees[triangle.tree].slots[triangle.number] != kNone;
    }
    bool canTakeBack(const InTree& fragment) const;
    void force(InTree fragment);
    void apply(const InTree& fragment);
    void takeBack(const InTree& fragment);
    void takeBackAll(const InTree& fragment);
    void activate(const InTree& triangle);
    void deactivate(const InTree& triangle);

    std::vector<Tree> _trees;
    std::vector<InTree> _active, _work, _forced;
    std::uint64_t _changes = 0;
};

} // namespace osgMultiTriangulation::core
