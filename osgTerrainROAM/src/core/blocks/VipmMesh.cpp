// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
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

/// A point of the outer edge of a block's rim.
glm::dvec3 rimPoint(const VipmBlocks& blocks, std::uint32_t block, GridPoint place)
{
    glm::dvec3 point = blocks.tile().tile.position(place.column, place.row);
    point.z = blocks.rimHeightM(block);
    return point;
}

/// Appends the part of a rim beyond an edge from one vertex of a block to another, if there is one.
void appendBeyond(const VipmBlock& block, const BlockRim& rim, std::uint32_t a, std::uint32_t b,
                  std::uint32_t outer, std::vector<LeafTriangle>& triangles)
{
    const GridPoint from = block.places[a], to = block.places[b];
    if (!rim.isBeyond(from, to)) return;
    const pm::Mesh& mesh = block.progressive.mesh;
    const auto heightM = [&](std::uint32_t wedge) { return mesh.positions[mesh.wedgePositions[wedge]].z; };
    const std::uint32_t corners[4] = {outer + a, outer + b, rim.outerOf(from), rim.outerOf(to)};
    for (const auto& t : BlockRim::trianglesBeyond(heightM(a), heightM(b)))
        triangles.push_back({{corners[t[0]], corners[t[1]], corners[t[2]]}});
}

} // namespace

VipmMesh::VipmMesh(std::shared_ptr<const VipmBlocks> blocks)
    : BlockMesh(blocks->grid(), blocks->tile().tile.frame().vertexStepM()),
      _blocks(std::move(blocks)),
      _players(_blocks->grid().count()),
      _levels(_blocks->grid().count(), kUnwritten)
{
    bound();
}

/// The box of a block that overlaps others goes down to the edge of its rim.
void VipmMesh::bound()
{
    _boxes.clear();
    for (std::uint32_t block = 0; block < grid().count(); ++block)
    {
        _boxes.push_back(_blocks->block(block).box);
        if (!overlaps()) continue;
        for (GridPoint place : BlockRim(tile().tile.grid(), grid(), block).outerPlaces())
            _boxes.back().include(rimPoint(*_blocks, block, place));
    }
}

/// Takes up edits of the tile: blocks that were made anew are written anew.
void VipmMesh::followTile()
{
    if (!isBehind()) return;
    const auto before = std::exchange(_blocks, presentBlocks(_blocks));
    for (std::uint32_t block = 0; block < grid().count(); ++block)
    {
        const bool isRemade = &before->block(block) != &_blocks->block(block);
        if (isRemade) _players[block] = nullptr;
        if (isRemade || before->rimHeightM(block) != _blocks->rimHeightM(block)) _levels[block] = kUnwritten;
    }
    bound();
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
        allowed.push_back(allowedErrorM(_blocks->block(block).box, view));
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

/// The vertices of the rim come first: one for each sample of the border, at all levels. A level uses the
/// first of the others only; the run grows by powers of two.
void VipmMesh::write(std::uint32_t block, std::size_t level)
{
    const VipmBlock& source = _blocks->block(block);
    auto& player = _players[block];
    if (!player) player = std::make_unique<pm::ProgressiveLevel>(source.progressive);
    player->moveTo(source.levels[level].steps);
    std::optional<BlockRim> rim;
    if (overlaps()) rim.emplace(tile().tile.grid(), grid(), block);
    const auto outer = static_cast<std::uint32_t>(rim ? rim->outerPlaces().size() : 0);
    const auto count = static_cast<std::uint32_t>(source.progressive.mesh.wedgeCount());
    const std::uint32_t capacity = outer + std::min(std::bit_ceil(player->wedgeCount()), count);
    if (_levels[block] == kUnwritten || capacity != vertexRun(block).count)
        writeVerticesOf(block, rim ? &*rim : nullptr, capacity);
    std::vector<LeafTriangle> triangles, beyond;
    pm::forEachDrawnFace(source.progressive, *player,
                         [&](const pm::Triangle& face, std::uint32_t)
                         {
                             triangles.push_back({{outer + face[0], outer + face[1], outer + face[2]}});
                             for (std::size_t i = 0; rim && i < 3; ++i)
                                 appendBeyond(source, *rim, face[i], face[(i + 1) % 3], outer, beyond);
                         });
    triangles.insert(triangles.end(), beyond.begin(), beyond.end());
    writeTriangles(block, triangles, std::bit_ceil(static_cast<std::uint32_t>(triangles.size())),
                   static_cast<std::uint32_t>(beyond.size()));
    _levels[block] = level;
}

void VipmMesh::writeVerticesOf(std::uint32_t block, const BlockRim* rim, std::uint32_t capacity)
{
    const VipmBlock& source = _blocks->block(block);
    const pm::Mesh& mesh = source.progressive.mesh;
    std::vector<Vertex> vertices;
    if (rim)
        for (const GridPoint place : rim->outerPlaces())
            vertices.push_back({rimPoint(*_blocks, block, place), place});
    const auto sunk = static_cast<std::uint32_t>(vertices.size());
    for (std::uint32_t wedge = 0; sunk + wedge < capacity; ++wedge)
        vertices.push_back({mesh.positions[mesh.wedgePositions[wedge]], source.places[wedge]});
    writeVertices(block, vertices, capacity, sunk);
}

std::size_t VipmMesh::memoryBytes() const
{
    std::size_t bytes = BlockMesh::memoryBytes() + _levels.capacity() * sizeof(std::size_t) +
                        _boxes.capacity() * sizeof(BlockBox);
    for (const auto& player : _players)
        if (player) bytes += player->narrowIndices().size_bytes() + player->wideIndices().size_bytes();
    return bytes;
}

PreparedVipm::PreparedVipm(std::shared_ptr<const RoamTile> tile, VipmBorders borders)
{
    const BlockGrid grid(tile->tile.grid());
    _blocks = std::make_shared<const VipmBlocks>(std::move(tile), grid, borders);
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
