// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Budget.h>
#include <viewlod/Sight.h>
#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/Refinement.h>

namespace osgTerrainROAM::core
{

/// Adapts a tree with two queues by priority: triangles that can split, diamonds that can merge.
/// Refining by priority is optimal: no other mesh with as many triangles has a smaller largest bound.
/// The queues are kept from frame to frame. While the view stays, nothing is computed; for another view the
/// priorities of all that is queued are computed anew, in place.
/// Invariant: while the tree is known, every leaf that can split and every diamond that can merge is queued.
/// Memory: 24 B for each of these. Cost: that of all queued priorities where the view has changed, and of the
/// changes.
/// Source: Duchaineau et al., *ROAMing Terrain*, 1997, section 5 (the two queues). Differs: what is not
/// possible any more is left in the queues until it comes up, or until priorities are computed anew.
class QueueDriver
{
public:
    /// Forgets everything, because the tree was changed from outside: the next refinement fills the queues.
    void forget() { _knowsTree = false; }

    /// Has all priorities computed anew in the next refinement, because bounds have changed.
    void recheck() { _isFresh = false; }

    /// Splits triangles above the tolerance of `ofLeaves` while there is room; merges diamonds below it, or
    /// of least priority to make room. What is out of sight has no priority. Writes the tolerance reached
    /// into the result. Returns false when the slice ended before.
    bool refine(DiamondTree& tree, const viewlod::ViewState& view, const viewlod::Sight& sight,
                const viewlod::Budget& ofLeaves, viewlod::Slice& slice, RefineResult& result);

    std::size_t memoryBytes() const;

private:
    struct Split
    {
        double priorityPx;
        TriangleId triangle;
        GridPoint place; ///< the middle of its base: vertex slots are used again
        friend bool operator<(const Split& a, const Split& b) { return a.priorityPx < b.priorityPx; }
    };
    struct Merge
    {
        double priorityPx;
        VertexSlot vertex;
        GridPoint place;
        friend bool operator<(const Merge& a, const Merge& b) { return a.priorityPx > b.priorityPx; }
    };

    /// The view that priorities were computed for.
    struct Seen
    {
        glm::dvec3 eye{0.0};
        double pixelsPerTangent = 0.0, nearM = 0.0, tolerancePx = 0.0;
        viewlod::Sight sight;
        bool operator==(const Seen&) const = default;
    };

    /// One refinement.
    struct Frame
    {
        DiamondTree& tree;
        const viewlod::ViewState& view;
        const viewlod::Sight& sight;
        const ActiveForEye active;
        double tolerancePx;
        viewlod::Slice& slice;
        RefineResult& result;
    };

    static bool isPossible(const DiamondTree& tree, const Split& split);
    static bool isPossible(const DiamondTree& tree, const Merge& merge);
    static double priority(Frame& frame, const SplitBound& bound);
    void fill(Frame& frame);
    void computeAnew(Frame& frame);
    bool claim(VertexSlot v, unsigned kind);
    void offer(Frame& frame, TriangleId t);
    void offer(Frame& frame, VertexSlot v);
    const Split* nextSplit(const DiamondTree& tree);
    const Merge* nextMerge(const DiamondTree& tree);
    void split(Frame& frame, TriangleId t);
    void merge(Frame& frame, VertexSlot v);

    static constexpr unsigned kItself = 4; ///< a vertex in the queue of merges; 0…3: a quadrant to be split

    std::vector<Split> _splits;        ///< heaps, largest first
    std::vector<Merge> _merges;        ///< smallest first
    std::vector<std::uint8_t> _queued; ///< by vertex: a bit for each kind that is in its queue
    Seen _seen;
    bool _knowsTree = false;
    bool _isFresh = false; ///< priorities are those of _seen
};

} // namespace osgTerrainROAM::core
