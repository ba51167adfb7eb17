// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/roam/ActiveInSight.h>
#include <osgTerrainROAM/core/roam/Outline.h>
#include <osgTerrainROAM/core/roam/PatchShape.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

namespace osgTerrainROAM::core
{

namespace
{

struct ScratchDescent
{
    const SplitBounds& bounds;
    const ActiveInSight active;
    std::vector<GridTriangle>& leaves;

    void visit(const GridTriangle& t, int level)
    {
        if (level == bounds.levels() || !active(bounds.bound(t.middleOfBase())))
        {
            leaves.push_back(t);
            return;
        }
        const auto children = t.children();
        visit(children[0], level + 1);
        visit(children[1], level + 1);
    }
};

} // namespace

void refineFromScratch(const SplitBounds& bounds, const viewlod::ViewState& view, double tolerancePx,
                       std::vector<GridTriangle>& leaves, const viewlod::Sight& sight)
{
    leaves.clear();
    ScratchDescent descent{bounds, ActiveInSight(view, tolerancePx, sight), leaves};
    for (const GridTriangle& root : rootTriangles(bounds.tile().tile.grid().side()))
        descent.visit(root, 0);
}

DrawnMesh meshOfLeaves(const SplitBounds& bounds, std::span<const GridTriangle> leaves)
{
    const PlacedTile& tile = bounds.tile().tile;
    DrawnMesh mesh;
    for (const GridTriangle& t : leaves)
        if (isDrawn(tile, t)) PatchShape::of(bounds.patchExponent()).append(tile, t, mesh);
    return mesh;
}

} // namespace osgTerrainROAM::core
