// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/Refinement.h>

namespace osgTerrainROAM::core
{

/// Adapts a tree with two queues by priority: triangles that can split, diamonds that can merge.
/// Refining by priority is optimal: no other mesh with as many triangles has a smaller largest bound.
/// It computes all priorities anew in every frame, which costs more than refining from scratch (4.4 ms for 10
/// 000 triangles against 0.4 ms, one thread at about 3 GHz): it serves as a reference.
/// Source: Duchaineau et al., *ROAMing Terrain*, 1997, section 5 (the two queues).
class QueueDriver
{
public:
    QueueDriver(DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                std::uint32_t maxLeaves, viewlod::Slice& slice, RefineResult& result);

    /// Splits triangles above the tolerance while there is room; merges diamonds below it, or of least
    /// priority to make room. Writes the tolerance reached into the result. Returns false when the slice
    /// ended before.
    bool refine();

private:
    struct Split
    {
        double priorityPx;
        TriangleId triangle;
        friend bool operator<(const Split& a, const Split& b) { return a.priorityPx < b.priorityPx; }
    };
    struct Merge
    {
        double priorityPx;
        VertexSlot vertex;
        friend bool operator<(const Merge& a, const Merge& b) { return a.priorityPx > b.priorityPx; }
    };

    double priority(const SplitBound& bound);
    void offer(TriangleId t);
    void offer(VertexSlot v);
    const Split* nextSplit();
    const Merge* nextMerge();
    void split(TriangleId t);
    void merge(VertexSlot v);

    DiamondTree& _tree;
    const viewlod::ViewState& _view;
    const ActiveForEye _active;
    double _tolerancePx;
    std::uint32_t _maxLeaves;
    viewlod::Slice& _slice;
    RefineResult& _result;
    std::vector<Split>
        _splits; ///< heaps, largest first; what is not possible any more is left out when it comes up
    std::vector<Merge> _merges; ///< smallest first
};

} // namespace osgTerrainROAM::core
