// SPDX-License-Identifier: Apache-2.0
// The triangle ceiling of a frame. Priorities nest, so the mesh at a tolerance has two triangles and one more for each
// triangle of the bintree whose priority exceeds it; the ceiling's tolerance is therefore an order statistic of the
// priorities. They are gathered above a guess that comes down until enough are there. (A best-first expansion with a
// heap gives the same number at ten times the cost. Refining in visit order until full would not: spec 1 D.)
#include <algorithm>
#include <vector>

#include <osgTerrainROAM/core/roam/Refinement.h>
#include <osgTerrainROAM/core/roam/TriangleCeiling.h>

namespace osgTerrainROAM::core
{

namespace
{

/// The predicate compares squares where priorities divide: this much keeps rounding on the ceiling's side.
constexpr double kRoundingMargin = 1.0 + 1e-12;

/// Gathers the priorities of all bintree triangles above a threshold, up to a limit. Triangles that the present mesh
/// has, most of them, come from its nodes; what lies below its leaves is computed.
class PrioritySweep
{
public:
    PrioritySweep(const RoamTile& tile, const BinTriangleTree& mesh, const viewlod::ViewState& view,
                  std::size_t limit)
        : _tile(tile), _mesh(mesh), _view(view), _limit(limit)
    {
    }

    std::vector<double>& above(double thresholdPx)
    {
        _thresholdPx = thresholdPx;
        _priorities.clear();
        for (const NodeIndex root : BinTriangleTree::kRoots)
            visitNode(root);
        return _priorities;
    }

    bool isFull() const { return _priorities.size() >= _limit; }

private:
    bool takes(const SplitBound& bound)
    {
        const double priority = priorityPx(_view, bound);
        if (priority <= _thresholdPx || isFull()) return false;
        _priorities.push_back(priority);
        return true;
    }

    void visitNode(NodeIndex t)
    {
        const BinTriangle& node = _mesh.node(t);
        if (node.splitSample == kNone || !takes(node.bound)) return;
        if (!node.isLeaf())
        {
            visitNode(node.firstChild);
            visitNode(node.firstChild + 1);
            return;
        }
        const auto sample = [&](int corner) { return _mesh.sampleOf(node.vertices[corner]); };
        visitBelow(node.splitSample, sample(0), sample(1), node.level + 1);
        visitBelow(node.splitSample, sample(2), sample(0), node.level + 1);
    }

    void visitBelow(SampleIndex apex, SampleIndex left, SampleIndex right, int level)
    {
        if (level == _tile.tile.levels()) return;
        const SampleIndex middle = (left + right) / 2;
        if (!takes(_tile.bound(middle))) return;
        visitBelow(middle, apex, left, level + 1);
        visitBelow(middle, right, apex, level + 1);
    }

    const RoamTile& _tile;
    const BinTriangleTree& _mesh;
    const viewlod::ViewState& _view;
    std::size_t _limit;
    double _thresholdPx = 0.0;
    std::vector<double> _priorities;
};

} // namespace

double toleranceWithinCeiling(const RoamTile& tile, const BinTriangleTree& mesh,
                              const viewlod::ViewState& view, const viewlod::Budget& budget, double guessPx)
{
    const std::size_t splits = std::max(budget.maxTriangles, 2u) - 2u;
    PrioritySweep sweep(tile, mesh, view, 4 * splits + 1024);
    double thresholdPx = std::max(guessPx, budget.errorTolerancePx);
    for (double factor = 0.5;;)
    {
        std::vector<double>& priorities = sweep.above(thresholdPx);
        if (sweep.isFull()) // a guess from a much calmer view: start again from far above
        {
            thresholdPx *= 64.0;
            factor = 0.7;
        }
        else if (priorities.size() > splits)
        {
            const auto first = priorities.begin() + static_cast<std::ptrdiff_t>(splits);
            std::nth_element(priorities.begin(), first, priorities.end(), std::greater<>());
            return std::max(*first * kRoundingMargin, budget.errorTolerancePx);
        }
        else if (thresholdPx <= budget.errorTolerancePx)
        {
            return budget.errorTolerancePx;
        }
        else
        {
            thresholdPx = std::max(thresholdPx * factor, budget.errorTolerancePx);
        }
    }
}

} // namespace osgTerrainROAM::core
