// SPDX-License-Identifier: Apache-2.0
// The tolerance at the triangle ceiling. Priorities nest, so the mesh at a tolerance has two triangles and
// one more for each triangle of the bintree whose priority exceeds it; the tolerance is therefore an order
// statistic of the priorities. They are gathered above a guess, which is lowered until there are enough. (A
// best-first expansion with a heap gives the same number at ten times the cost; refining in visit order until
// the mesh is full does not give it.)
#include <algorithm>
#include <vector>

#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/Refinement.h>
#include <osgTerrainROAM/core/roam/TriangleCeiling.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Gathers the priorities of all bintree triangles above a threshold, up to a limit.
class PrioritySweep
{
public:
    PrioritySweep(const SplitBounds& bounds, const viewlod::ViewState& view, const viewlod::Sight& sight,
                  std::size_t limit)
        : _bounds(bounds), _view(view), _sight(sight), _limit(limit)
    {
    }

    std::vector<double>& above(double thresholdPx)
    {
        _thresholdPx = thresholdPx;
        _priorities.clear();
        for (const GridTriangle& root : rootTriangles(_bounds.tile().tile.grid().side()))
            visit(root, 0);
        return _priorities;
    }

    bool isFull() const { return _priorities.size() >= _limit; }

private:
    void visit(const GridTriangle& t, int level)
    {
        if (level == _bounds.levels()) return;
        const SplitBound bound = _bounds.bound(t.middleOfBase());
        const double priority = priorityPx(_view, bound);
        if (priority <= _thresholdPx || isFull()) return;
        if (!_sight.touches(glm::dvec3(bound.centre), bound.radiusM)) return;
        _priorities.push_back(priority);
        const auto children = t.children();
        visit(children[0], level + 1);
        visit(children[1], level + 1);
    }

    const SplitBounds& _bounds;
    const viewlod::ViewState& _view;
    const viewlod::Sight& _sight;
    std::size_t _limit;
    double _thresholdPx = 0.0;
    std::vector<double> _priorities;
};

} // namespace

double toleranceWithinCeiling(const SplitBounds& bounds, const viewlod::ViewState& view,
                              const viewlod::Budget& budget, double guessPx, const viewlod::Sight& sight)
{
    const std::size_t splits = std::max(budget.maxTriangles, 2u) - 2u;
    PrioritySweep sweep(bounds, view, sight, 4 * splits + 1024);
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
            return std::max(*first * kPriorityRounding, budget.errorTolerancePx);
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
