// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

namespace osgTerrainROAM::core
{

namespace
{

struct Descent
{
    const RoamTile& tile;
    const ActiveForEye active;
    std::vector<SampleTriangle>& leaves;

    void visit(const SampleTriangle& t, int level)
    {
        const SampleIndex middle = (t[1] + t[2]) / 2;
        if (level == tile.tile.levels() || !active(tile.bound(middle)))
        {
            leaves.push_back(t);
            return;
        }
        visit({middle, t[0], t[1]}, level + 1);
        visit({middle, t[2], t[0]}, level + 1);
    }
};

} // namespace

void refineFromScratch(const RoamTile& tile, const viewlod::ViewState& view, double tolerancePx,
                       std::vector<SampleTriangle>& leaves)
{
    leaves.clear();
    Descent descent{tile, ActiveForEye(view, tolerancePx), leaves};
    const int side = tile.tile.side();
    const auto sample = [side](GridPoint p) { return static_cast<SampleIndex>(p.row * side + p.column); };
    for (const GridTriangle& root : rootTriangles(side))
        descent.visit({sample(root.apex), sample(root.left), sample(root.right)}, 0);
}

} // namespace osgTerrainROAM::core
