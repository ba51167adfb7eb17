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

/// Duchaineau's driver: a queue of the triangles that can split and one of the diamonds that can merge, by priority.
/// Refining by priority is optimal: for a number of triangles the largest bound is the least there is.
/// All priorities are computed anew in every frame: what this costs is why ROAM was left.
/// Source: Duchaineau et al. 1997, §5; spec 1 D, "Priorities and the two queues".
class QueueDriver
{
public:
    QueueDriver(DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                std::uint32_t maxLeaves, viewlod::Slice& slice, RefineResult& result);

    /// Splits above the tolerance while there is room, merges what is below it or what must make room. The tolerance
    /// reached goes into the result. False when the slice ended before.
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
