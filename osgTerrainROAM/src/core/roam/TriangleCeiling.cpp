// SPDX-License-Identifier: Apache-2.0
// The triangle ceiling of a frame: a best-first expansion of the bintree from its roots, largest priority first.
// Priorities nest, so the first one that no longer fits is the tolerance that the whole frame can have (never
// "refine in visit order until full": spec 1 D, Triangle ceiling).
#include <queue>
#include <vector>

#include <osgTerrainROAM/core/roam/Refinement.h>

namespace osgTerrainROAM::core
{

namespace
{

struct Candidate
{
    double priorityPx;
    SampleIndex apex, left, right;
    int level;

    friend bool operator<(const Candidate& a, const Candidate& b) { return a.priorityPx < b.priorityPx; }
};

/// The predicate compares squares where priorities divide: this much keeps rounding on the ceiling's side.
constexpr double kRoundingMargin = 1.0 + 1e-12;

} // namespace

double toleranceWithinCeiling(const RoamTile& tile, const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    std::priority_queue<Candidate> open;
    const auto offer = [&](SampleIndex apex, SampleIndex left, SampleIndex right, int level)
    {
        if (level == tile.tile.levels()) return;
        const double priority = priorityPx(view, tile.bound((left + right) / 2));
        if (priority > budget.errorTolerancePx) open.push({priority, apex, left, right, level});
    };
    const auto side = static_cast<SampleIndex>(tile.tile.side());
    const SampleIndex southEast = side - 1, northWest = side * (side - 1), northEast = side * side - 1;
    offer(southEast, northEast, 0, 0);
    offer(northWest, 0, northEast, 0);
    for (std::uint32_t leaves = 2; !open.empty(); ++leaves)
    {
        const Candidate split = open.top();
        if (leaves >= budget.maxTriangles) return split.priorityPx * kRoundingMargin;
        open.pop();
        const SampleIndex middle = (split.left + split.right) / 2;
        offer(middle, split.apex, split.left, split.level + 1);
        offer(middle, split.right, split.apex, split.level + 1);
    }
    return budget.errorTolerancePx;
}

} // namespace osgTerrainROAM::core
