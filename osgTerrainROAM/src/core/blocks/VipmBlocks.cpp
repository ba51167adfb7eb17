// SPDX-License-Identifier: Apache-2.0
// View-independent progressive meshes of terrain blocks.
// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), sections 4.1 and 4.2 (blocks,
// borders);
// *Cache-friendly view-independent progressive meshes* (Graphicon 2003), section 5 (tswap). Differs: errors
// are measured over all samples instead of kept with each collapse.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/simplify/ErrorLadder.h>
#include <osgPMObjects/core/simplify/Simplify.h>
#include <osgTerrainROAM/core/blocks/BlockRim.h>
#include <osgTerrainROAM/core/blocks/VipmBlocks.h>

#include "BlocksOfRects.h"
#include "SurfaceError.h"

namespace osgTerrainROAM::core
{

namespace
{

namespace pm = osgPMObjects::core;

constexpr double kLadderRatio = 1.19; ///< the fourth root of 2

/// A sample as simplification sees it: on the round Earth in the plane of the grid, where borders are
/// straight and no triangle that is turned over there looks sound.
glm::dvec3 flatPosition(const PlacedTile& tile, int column, int row)
{
    const glm::dvec3 position = tile.position(column, row);
    if (tile.frame().placement() == Placement::planar) return position;
    const double cell = tile.grid().cellSide();
    return {column / cell * tile.field().spacingEastM, row / cell * tile.field().spacingNorthM,
            tile.frame().heightOf(position)};
}

/// The samples of a block, and the triangles between them.
class BlockSurface
{
public:
    BlockSurface(const PlacedTile& tile, const BlockGrid& grid, std::uint32_t block)
        : _rect(rectOf(tile.grid(), grid, block)), _columns(_rect.east - _rect.west + 1)
    {
        for (int row = _rect.south; row <= _rect.north; ++row)
            for (int column = _rect.west; column <= _rect.east; ++column)
            {
                mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
                mesh.positions.push_back(flatPosition(tile, column, row));
                sides.push_back(static_cast<std::uint8_t>(
                    (row == _rect.south) << south | (column == _rect.east) << east |
                    (row == _rect.north) << north | (column == _rect.west) << west));
            }
        mesh.materials.push_back({});
        mesh.parts.push_back({});
        for (int row = _rect.south; row < _rect.north; ++row)
            for (int column = _rect.west; column < _rect.east; ++column)
                addSquare(column, row);
    }

    const GridRect& rect() const { return _rect; }
    GridPoint place(std::size_t position) const
    {
        const int i = static_cast<int>(position);
        return {_rect.west + i % _columns, _rect.south + i / _columns};
    }

    pm::Mesh mesh;
    std::vector<std::uint8_t> sides; ///< by position: a bit for each side of the block on which it lies

private:
    std::uint32_t at(int column, int row) const
    {
        return static_cast<std::uint32_t>((row - _rect.south) * _columns + column - _rect.west);
    }

    /// Its diagonal is that of the finest level of the bintree.
    void addSquare(int column, int row)
    {
        const std::uint32_t sw = at(column, row), se = at(column + 1, row), ne = at(column + 1, row + 1),
                            nw = at(column, row + 1);
        const bool rises = (column + row) % 2 == 0;
        mesh.faces.push_back({rises ? std::array{se, ne, sw} : std::array{sw, se, nw}, 0, 0});
        mesh.faces.push_back({rises ? std::array{nw, sw, ne} : std::array{ne, nw, se}, 0, 0});
    }

    GridRect _rect;
    int _columns;
};

/// Finds the sample of each vertex of a progressive mesh by its position.
std::vector<GridPoint> placesOf(const pm::ProgressiveMesh& progressive, const BlockSurface& surface)
{
    const auto less = [](const glm::dvec3& a, const glm::dvec3& b)
    { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::vector<std::size_t> order(surface.mesh.positions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b)
              { return less(surface.mesh.positions[a], surface.mesh.positions[b]); });
    std::vector<GridPoint> places;
    for (const std::uint32_t position : progressive.mesh.wedgePositions)
        places.push_back(surface.place(*std::lower_bound(
            order.begin(), order.end(), progressive.mesh.positions[position],
            [&](std::size_t i, const glm::dvec3& p) { return less(surface.mesh.positions[i], p); })));
    return places;
}

/// Measures a level. Returns false where a triangle is turned over in plan.
bool measure(const VipmBlock& block, const pm::ProgressiveLevel& level, const SurfaceError& surface,
             double& errorM)
{
    bool isSound = true;
    pm::forEachDrawnFace(
        block.progressive, level,
        [&](const pm::Triangle& face, std::uint32_t)
        {
            const PlanTriangle plan{{block.places[face[0]], block.places[face[1]], block.places[face[2]]}};
            isSound = isSound && plan.doubleArea() > 0;
            if (!isSound) return;
            const auto at = [&](std::size_t i)
            { return block.progressive.mesh.positions[block.progressive.mesh.wedgePositions[face[i]]]; };
            errorM = std::max(errorM, surface.largestM(plan, {at(0), at(1), at(2)}));
        });
    return isSound;
}

/// The number of triangles of a level's rim: two beyond each edge of the border.
std::uint32_t rimTriangles(const VipmBlock& block, const pm::ProgressiveLevel& level, const BlockRim& rim)
{
    std::uint32_t edges = 0;
    pm::forEachDrawnFace(block.progressive, level,
                         [&](const pm::Triangle& face, std::uint32_t)
                         {
                             for (std::size_t i = 0; i < 3; ++i)
                                 edges +=
                                     rim.isBeyond(block.places[face[i]], block.places[face[(i + 1) % 3]]);
                         });
    return 2 * edges;
}

} // namespace

VipmBlock makeVipmBlock(const PlacedTile& tile, const BlockGrid& grid, std::uint32_t index,
                        std::optional<VipmBorders> borders)
{
    const BlockSurface surface(tile, grid, index);
    const BlockRim rim(tile.grid(), grid, index);
    pm::SimplifySettings settings;
    settings.keepSymmetry = false;
    settings.growLeaves = false;
    settings.keepSeams = false;
    settings.isHeightField = true;
    if (borders) settings.lines = surface.sides;
    if (borders == VipmBorders::locked)
        for (const std::uint8_t sides : surface.sides)
            settings.locked.push_back(sides != 0);
    const pm::CollapseSequence sequence = pm::simplify(surface.mesh, settings);
    VipmBlock block;
    block.progressive =
        pm::buildProgressiveMesh(surface.mesh, sequence, {.arrangement = pm::Arrangement::tswap});
    block.places = placesOf(block.progressive, surface);
    for (std::size_t wedge = 0; wedge < block.places.size(); ++wedge)
        block.progressive.mesh.positions[block.progressive.mesh.wedgePositions[wedge]] =
            tile.position(block.places[wedge].column, block.places[wedge].row);
    for (std::size_t i = 0; i < surface.mesh.positions.size(); ++i)
        block.box.include(tile.position(surface.place(i).column, surface.place(i).row));
    std::vector<std::uint32_t> faces{sequence.facesBefore};
    for (const pm::CollapseStep& step : sequence.steps)
        faces.push_back(step.facesAfter);
    const SurfaceError error(tile, surface.rect());
    pm::ProgressiveLevel level(block.progressive);
    double errorM = 0.0;
    for (const std::uint32_t steps : pm::ladderSteps(faces, kLadderRatio))
    {
        level.moveTo(steps);
        if (level.faceCount() == 0 || !measure(block, level, error, errorM)) break;
        const std::uint32_t ofRim = borders == VipmBorders::overlapping ? rimTriangles(block, level, rim) : 0;
        const double roundedM = steps == 0 ? 0.0 : errorM + tile.frame().vertexStepM();
        block.levels.push_back(
            {steps, level.faceCount() + ofRim, std::nextafter(static_cast<float>(roundedM), 1e30f)});
    }
    return block;
}

VipmBlocks::VipmBlocks(std::shared_ptr<const RoamTile> tile, const BlockGrid& grid, VipmBorders borders)
    : _tile(std::move(tile)),
      _grid(grid),
      _borders(borders),
      _blocks(grid.count()),
      _rimHeightsM(grid.count()),
      _revision(_tile->revision())
{
    std::vector<std::uint32_t> all(grid.count());
    std::iota(all.begin(), all.end(), 0u);
    make(all);
}

void VipmBlocks::make(std::span<const std::uint32_t> blocks)
{
    pm::parallelShares(blocks.size(), 4,
                       [&](std::size_t first, std::size_t last, std::size_t)
                       {
                           for (std::size_t i = first; i < last; ++i)
                               _blocks[blocks[i]] = std::make_shared<const VipmBlock>(
                                   makeVipmBlock(_tile->tile, _grid, blocks[i], _borders));
                       });
    for (std::uint32_t block = 0; block < _grid.count(); ++block)
        _rimHeightsM[block] = heightOfRimM(block);
}

/// A surface between samples is nowhere lower than the lowest of them; vertices are rounded to steps.
double VipmBlocks::heightOfRimM(std::uint32_t block) const
{
    constexpr double kSteps = 4.0;
    const int column = static_cast<int>(block) % _grid.columns(),
              row = static_cast<int>(block) / _grid.columns();
    double lowestM = _blocks[block]->box.low.z;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, _grid.rows() - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, _grid.columns() - 1); ++c)
            lowestM = std::min(lowestM, _blocks[_grid.blockAt(c, r)]->box.low.z);
    return lowestM - kSteps * _tile->tile.frame().vertexStepM();
}

std::shared_ptr<const VipmBlocks> VipmBlocks::remade(std::span<const GridRect> moved) const
{
    const auto present = std::make_shared<VipmBlocks>(*this);
    present->_revision = _tile->revision();
    present->make(blocksOf(_grid, moved));
    return present;
}

std::size_t VipmBlocks::memoryBytes() const
{
    std::size_t bytes = 0;
    for (const auto& block : _blocks)
        bytes += block->progressive.overheadBytes() +
                 block->progressive.mesh.positions.capacity() * sizeof(glm::dvec3) +
                 block->progressive.mesh.wedgePositions.capacity() * sizeof(std::uint32_t) +
                 block->places.capacity() * sizeof(GridPoint) + block->levels.capacity() * sizeof(VipmLevel);
    return bytes;
}

} // namespace osgTerrainROAM::core
