// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <osgTerrainROAM/core/blocks/DecimatedMesh.h>

#include "BlocksOfRects.h"

namespace osgTerrainROAM::core
{

namespace
{

/// The errors of a tile as it is now: those that are there, or a copy in which the blocks that were edited
/// are measured anew.
std::shared_ptr<const BlockErrors> presentErrors(const std::shared_ptr<const BlockErrors>& errors,
                                                 std::vector<GridRect>* moved = nullptr)
{
    if (errors->tile().revision() == errors->revision()) return errors;
    std::vector<GridRect> rects = movedSince(errors->tile(), errors->revision());
    const auto present = std::make_shared<BlockErrors>(*errors);
    present->remeasure(rects);
    if (moved) *moved = std::move(rects);
    return present;
}

/// The ends of the edge of the next level in whose middle a vertex of a level lies. Diagonals alternate as
/// those of innerTriangles().
std::pair<GridPoint, GridPoint> parentsOf(GridPoint p, GridPoint origin, int level)
{
    const int step = 1 << level;
    const bool isOddColumn = (p.column >> level) % 2 != 0, isOddRow = (p.row >> level) % 2 != 0;
    if (!isOddRow) return {{p.column - step, p.row}, {p.column + step, p.row}};
    if (!isOddColumn) return {{p.column, p.row - step}, {p.column, p.row + step}};
    const bool rises =
        ((origin.column + p.column - step) / (2 * step) + (origin.row + p.row - step) / (2 * step)) % 2 == 0;
    const int up = rises ? step : -step;
    return {{p.column - step, p.row - up}, {p.column + step, p.row + up}};
}

bool isOfLevel(GridPoint p, int level)
{
    return ((p.column | p.row) & ((1 << level) - 1)) == 0;
}

} // namespace

DecimatedMesh::DecimatedMesh(std::shared_ptr<const BlockErrors> errors)
    : BlockMesh(errors->grid(), errors->tile().tile.frame().vertexStepM()),
      _errors(std::move(errors)),
      _states(_errors->grid().count())
{
}

RefineResult DecimatedMesh::refine(const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    followTile();
    _isMorphed = _isMorphing;
    RefineResult result = show(levelsInCeiling(*_errors, AllowedErrors(*_errors, view),
                                               budget.errorTolerancePx, budget.maxTriangles, _isMorphing));
    result.ceilingBound = result.tolerancePx > budget.errorTolerancePx;
    return result;
}

RefineResult DecimatedMesh::refine(double errorM)
{
    followTile();
    _isMorphed = false;
    return show({chooseLevels(*_errors, AllowedErrors(*_errors, errorM), 1.0), 0.0, 0});
}

/// Takes up edits of the tile: blocks that hold moved points are measured and written anew.
void DecimatedMesh::followTile()
{
    if (!isBehind()) return;
    std::vector<GridRect> moved;
    _errors = presentErrors(_errors, &moved);
    for (const std::uint32_t block : blocksOf(grid(), moved))
        _states[block] = {};
}

DecimatedMesh::State DecimatedMesh::stateOf(std::uint32_t block) const
{
    State state{shapeAt(grid(), _levels, block), _levels[block], {}};
    for (int side = 0; side < kSides; ++side)
        state.borders[side] = borderLevel(grid(), _levels, block, side);
    return state;
}

/// Writes the blocks whose state differs from what is written.
RefineResult DecimatedMesh::show(LevelsInCeiling levels)
{
    clearChanges();
    RefineResult result;
    _levels = std::move(levels.levels);
    for (std::uint32_t block = 0; block < grid().count(); ++block)
    {
        const State state = stateOf(block);
        result.leaves += core::triangleCount(grid().exponent(), state.shape);
        if (state == _states[block]) continue;
        if (state.shape.level < _states[block].shape.level) ++result.splits;
        if (state.shape.level > _states[block].shape.level) ++result.merges;
        write(block, state);
    }
    result.checks = grid().count();
    result.triangles = triangleCount();
    result.tolerancePx = result.errorBoundPx = levels.tolerance;
    return result;
}

/// A vertex of the border follows the border's level, one inside the block's; others are where they are. The
/// ends of an edge that a vertex comes from are of a coarser level: they may move with a border, and the
/// vertex with them.
glm::dvec3 DecimatedMesh::drawnAt(const State& state, GridPoint origin, GridPoint local) const
{
    const PlacedTile& placed = tile().tile;
    const glm::dvec3 there = placed.position(origin.column + local.column, origin.row + local.row);
    const int last = grid().side();
    double level = state.level;
    if (local.row == 0)
        level = state.borders[south];
    else if (local.row == last)
        level = state.borders[north];
    else if (local.column == 0)
        level = state.borders[west];
    else if (local.column == last)
        level = state.borders[east];
    const int whole = static_cast<int>(level);
    const double share = level - whole;
    if (share == 0.0 || !isOfLevel(local, whole) || isOfLevel(local, whole + 1)) return there;
    const auto [a, b] = parentsOf(local, origin, whole);
    return glm::mix(there, (drawnAt(state, origin, a) + drawnAt(state, origin, b)) * 0.5, share);
}

void DecimatedMesh::write(std::uint32_t block, const State& state)
{
    const GridPoint origin = grid().origin(block);
    const PlacedTile& placed = tile().tile;
    const int level = state.shape.level, squares = grid().side() >> level;
    if (state.shape.level != _states[block].shape.level || state.level != _states[block].level ||
        !std::equal(state.borders, state.borders + kSides, _states[block].borders))
    {
        std::vector<Vertex> vertices;
        for (int row = 0; row <= squares; ++row)
            for (int column = 0; column <= squares; ++column)
            {
                const GridPoint local{column << level, row << level};
                vertices.push_back(
                    {drawnAt(state, origin, local), {origin.column + local.column, origin.row + local.row}});
            }
        writeVertices(block, vertices, static_cast<std::uint32_t>(vertices.size()));
    }
    if (state.shape != _states[block].shape || _states[block].level < 0.0)
    {
        std::vector<LeafTriangle> triangles;
        const auto slot = [&](GridPoint p)
        { return static_cast<std::uint32_t>((p.row >> level) * (squares + 1) + (p.column >> level)); };
        for (const BlockTriangle& t : trianglesOf(grid().exponent(), state.shape, origin))
        {
            const int west = std::min({t[0].column, t[1].column, t[2].column}) + origin.column;
            const int south = std::min({t[0].row, t[1].row, t[2].row}) + origin.row;
            if (west >= placed.grid().dataColumns() - 1 || south >= placed.grid().dataRows() - 1) continue;
            triangles.push_back({{slot(t[0]), slot(t[1]), slot(t[2])}});
        }
        writeTriangles(block, triangles, 2u * static_cast<std::uint32_t>(squares * squares));
    }
    _states[block] = state;
}

std::size_t DecimatedMesh::memoryBytes() const
{
    return BlockMesh::memoryBytes() + _levels.capacity() * sizeof(double) +
           _states.capacity() * sizeof(State);
}

PreparedDecimation::PreparedDecimation(std::shared_ptr<const RoamTile> tile)
{
    const BlockGrid grid(tile->tile.grid());
    _errors = std::make_shared<const BlockErrors>(std::move(tile), grid);
}

std::unique_ptr<TerrainMesh> PreparedDecimation::newMesh() const
{
    return std::make_unique<DecimatedMesh>(presentErrors(_errors));
}

} // namespace osgTerrainROAM::core
