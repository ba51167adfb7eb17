// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgTerrainROAM/core/blocks/VipmMesh.h>

#include "BlocksOfRects.h"
#include "CeilingSearch.h"

namespace osgTerrainROAM::core
{

namespace
{

namespace pm = osgPMObjects::core;

std::shared_ptr<const VipmBlocks> presentBlocks(const std::shared_ptr<const VipmBlocks>& blocks)
{
    if (blocks->tile().revision() == blocks->revision()) return blocks;
    return blocks->remade(movedSince(blocks->tile(), blocks->revision()));
}

} // namespace

VipmMesh::VipmMesh(std::shared_ptr<const VipmBlocks> blocks)
    : BlockMesh(blocks->grid(), blocks->tile().tile.frame().vertexStepM()),
      _blocks(std::move(blocks)),
      _players(_blocks->grid().count()),
      _levels(_blocks->grid().count(), kUnwritten)
{
}

/// Takes up edits of the tile: blocks that were made anew are written anew.
void VipmMesh::followTile()
{
    if (!isBehind()) return;
    const auto before = std::exchange(_blocks, presentBlocks(_blocks));
    for (std::uint32_t block = 0; block < grid().count(); ++block)
    {
        if (&before->block(block) == &_blocks->block(block)) continue;
        _players[block] = nullptr;
        _levels[block] = kUnwritten;
    }
}

VipmMesh::Choice VipmMesh::choose(const std::vector<double>& allowedPerTolerance, double tolerance) const
{
    Choice choice{{}, tolerance, 0};
    for (std::uint32_t block = 0; block < grid().count(); ++block)
    {
        const std::vector<VipmLevel>& levels = _blocks->block(block).levels;
        std::size_t level = levels.size() - 1;
        while (level > 0 && levels[level].errorM > allowedPerTolerance[block] * tolerance)
            --level;
        choice.levels.push_back(level);
        choice.triangles += levels[level].triangles;
    }
    return choice;
}

RefineResult VipmMesh::refine(const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    followTile();
    std::vector<double> allowed;
    for (std::uint32_t block = 0; block < grid().count(); ++block)
        allowed.push_back(allowedErrorM(box(block), view));
    RefineResult result = show(withinCeiling(budget.errorTolerancePx, budget.maxTriangles,
                                             [&](double tolerance) { return choose(allowed, tolerance); }));
    result.ceilingBound = result.tolerancePx > budget.errorTolerancePx;
    return result;
}

RefineResult VipmMesh::refine(double errorM)
{
    followTile();
    RefineResult result = show(choose(std::vector<double>(grid().count(), errorM), 1.0));
    result.tolerancePx = result.errorBoundPx = 0.0;
    return result;
}

RefineResult VipmMesh::show(const Choice& choice)
{
    clearChanges();
    RefineResult result;
    for (std::uint32_t block = 0; block < grid().count(); ++block)
    {
        const std::size_t level = choice.levels[block];
        if (level == _levels[block]) continue;
        (level < _levels[block] ? result.splits : result.merges) += 1;
        write(block, level);
    }
    result.checks = grid().count();
    result.leaves = result.triangles = triangleCount();
    result.tolerancePx = result.errorBoundPx = choice.tolerance;
    return result;
}

/// A level uses the first vertices only; the run grows by powers of two.
void VipmMesh::write(std::uint32_t block, std::size_t level)
{
    const VipmBlock& source = _blocks->block(block);
    const pm::Mesh& mesh = source.progressive.mesh;
    auto& player = _players[block];
    if (!player) player = std::make_unique<pm::ProgressiveLevel>(source.progressive);
    player->moveTo(source.levels[level].steps);
    const std::uint32_t count = static_cast<std::uint32_t>(mesh.wedgeCount());
    const std::uint32_t capacity = std::min(std::bit_ceil(player->wedgeCount()), count);
    if (_levels[block] == kUnwritten || capacity != vertexRun(block).count)
    {
        std::vector<Vertex> vertices;
        for (std::uint32_t wedge = 0; wedge < capacity; ++wedge)
            vertices.push_back({mesh.positions[mesh.wedgePositions[wedge]], source.places[wedge]});
        writeVertices(block, vertices, capacity);
    }
    std::vector<LeafTriangle> triangles;
    pm::forEachDrawnFace(source.progressive, *player,
                         [&](const pm::Triangle& face, std::uint32_t) {
                             triangles.push_back({{face[0], face[1], face[2]}});
                         });
    writeTriangles(block, triangles, std::bit_ceil(static_cast<std::uint32_t>(triangles.size())));
    _levels[block] = level;
}

std::size_t VipmMesh::memoryBytes() const
{
    std::size_t bytes = BlockMesh::memoryBytes() + _levels.capacity() * sizeof(std::size_t);
    for (const auto& player : _players)
        if (player) bytes += player->narrowIndices().size_bytes() + player->wideIndices().size_bytes();
    return bytes;
}

PreparedVipm::PreparedVipm(std::shared_ptr<const RoamTile> tile)
{
    const BlockGrid grid(tile->tile.grid());
    _blocks = std::make_shared<const VipmBlocks>(std::move(tile), grid);
}

std::unique_ptr<TerrainMesh> PreparedVipm::newMesh() const
{
    return std::make_unique<VipmMesh>(presentBlocks(_blocks));
}

std::uint32_t PreparedVipm::fewestTriangles() const
{
    std::uint32_t triangles = 0;
    for (std::uint32_t block = 0; block < _blocks->grid().count(); ++block)
        triangles += _blocks->block(block).levels.back().triangles;
    return triangles;
}

} // namespace osgTerrainROAM::core
