// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/TinLeavesRival.h"

#include <bit>
#include <cmath>
#include <set>
#include <utility>

#include <osgTerrainROAM/core/bisection/BisectionModel.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>

#include "measurement/ProcessorTime.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kLegCells = 16, kSquareCells = 64, kMostCells = 1024;

/// The raster as a square over half-edges, and what all its meshes share.
struct LeafTerrain
{
    std::shared_ptr<const RoamTile> tile;
    std::unique_ptr<const BisectionModel> model;
    std::unique_ptr<const BisectionMesh> first; ///< what is computed once for all meshes

    /// The point of the grid of a place on the surface.
    static GridPoint gridOf(const PlacedTile& tile, const glm::dvec3& point)
    {
        const glm::dvec2 place = tile.frame().gridAt(point);
        return {static_cast<int>(std::lround(place.x)), static_cast<int>(std::lround(place.y))};
    }
};

BisectionSurface surfaceOver(const PlacedTile& tile)
{
    const int cells = tile.grid().dataColumns() - 1;
    const double last = cells;
    auto square = CoarseMesh::make({{0, 0, 0}, {last, 0, 0}, {last, last, 0}, {0, last, 0}}, {{0, 1, 2, 3}},
                                   tile.field().name);
    const int levels = 2 * std::countr_zero(static_cast<unsigned>(cells)) - 1; // all vertices are samples
    return {std::move(*square), levels, [&tile](const glm::dvec3& p) {
                return tile.position(static_cast<int>(p.x), static_cast<int>(p.y));
            }};
}

/// The triangles that carry TINs.
std::vector<Bisector> carriersOf(const BisectionSurface& surface, const PlacedTile& tile)
{
    const int cells = tile.grid().dataColumns() - 1;
    const int level =
        2 * std::countr_zero(static_cast<unsigned>(cells / kLegCells)) - 1; // legs along the axes
    std::vector<Bisector> carriers;
    std::set<std::pair<int, int>> squares;
    for (std::uint32_t side = 0; side < surface.mesh().sides(); ++side)
        for (std::uint32_t node = 1u << level; node < 2u << level; ++node)
        {
            const Bisector t{side, node};
            const GridPoint apex = LeafTerrain::gridOf(tile, surface.point(surface.cornersOf(t)[2]));
            if (apex.column % kSquareCells != kLegCells || apex.row % kSquareCells != 2 * kLegCells) continue;
            if (squares.emplace(apex.column / kSquareCells, apex.row / kSquareCells).second)
                carriers.push_back(t);
        }
    return carriers;
}

/// A sample of a carrier that is farther from its TIN than allowed: the worst of each triangle.
std::vector<PatchPoint> worstSamples(const PlacedTile& tile, const BisectionPatch& patch,
                                     const PlanTriangle& carrier, double errorM)
{
    std::vector<PatchPoint> worst;
    for (const CornerVertices& t : patch.triangles)
    {
        PlanTriangle plan{};
        glm::dvec3 corners[3];
        for (std::size_t i = 0; i < 3; ++i)
        {
            corners[i] = patch.points[t[i]].point;
            plan.corners[i] = LeafTerrain::gridOf(tile, corners[i]);
        }
        double most = errorM;
        std::optional<GridPoint> place;
        plan.forEachRow(tile.grid().dataColumns(), tile.grid().dataRows(),
                        [&](int row, int west, int east)
                        {
                            for (int column = west; column <= east; ++column)
                            {
                                const auto b = plan.at(column, row);
                                const double drawnM = corners[0].z + b.u * (corners[1].z - corners[0].z) +
                                                      b.w * (corners[2].z - corners[0].z);
                                const double off = std::abs(tile.samples().heightM(column, row) - drawnM);
                                if (off <= most) continue;
                                most = off;
                                place = GridPoint{column, row};
                            }
                        });
        if (!place) continue;
        const auto b = carrier.at(place->column, place->row);
        worst.push_back({{1.0 - b.u - b.w, b.u, b.w}, tile.position(place->column, place->row)});
    }
    return worst;
}

BisectionPatch patchOf(const BisectionSurface& surface, const PlacedTile& tile, Bisector carrier,
                       double errorM)
{
    PlanTriangle plan{};
    const CornerVertices corners = surface.cornersOf(carrier);
    for (std::size_t i = 0; i < 3; ++i)
        plan.corners[i] = LeafTerrain::gridOf(tile, surface.point(corners[i]));
    std::vector<PatchPoint> inside;
    while (true)
    {
        BisectionPatch patch = makePatch(surface, carrier, inside);
        const auto worst = worstSamples(tile, patch, plan, errorM);
        if (worst.empty()) return patch;
        inside.insert(inside.end(), worst.begin(), worst.end());
    }
}

std::shared_ptr<const LeafTerrain> terrainOf(const std::shared_ptr<const RoamTile>& tile, double errorM)
{
    const auto terrain = std::make_shared<LeafTerrain>();
    terrain->tile = tile;
    BisectionSurface surface = surfaceOver(tile->tile);
    std::vector<BisectionPatch> patches;
    for (const Bisector carrier : carriersOf(surface, tile->tile))
        patches.push_back(patchOf(surface, tile->tile, carrier, errorM));
    terrain->model = std::make_unique<BisectionModel>(std::move(surface), std::move(patches));
    const std::shared_ptr<const BisectionBounds> bounds(std::shared_ptr<void>(), &terrain->model->bounds);
    terrain->first =
        std::make_unique<BisectionMesh>(terrain->model->surface, terrain->model->patches, bounds);
    return terrain;
}

class LeafMesh final : public RivalMesh
{
public:
    explicit LeafMesh(std::shared_ptr<const LeafTerrain> terrain)
        : _terrain(std::move(terrain)), _mesh(*_terrain->first)
    {
    }

    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override
    {
        _changes = _mesh.refine({.eye = view.eyeWorld,
                                 .tolerance = budget.errorTolerancePx / view.guaranteedPixelsPerTangent(),
                                 .nearest = view.nearM});
        _leaves += _changes.split - _changes.merged;
        RefineResult result;
        result.triangles = result.leaves = _leaves;
        result.tolerancePx = result.errorBoundPx = budget.errorTolerancePx;
        return result;
    }

    DrawnMesh drawn() const override
    {
        const PlacedTile& tile = _terrain->tile->tile;
        DrawnMesh mesh;
        mesh.stepM = tile.frame().vertexStepM();
        std::vector<std::uint32_t> slots;
        const auto slotOf = [&](std::uint32_t vertex)
        {
            if (vertex >= slots.size()) slots.resize(vertex + vertex / 4 + 1, kNone);
            if (slots[vertex] != kNone) return slots[vertex];
            const glm::dvec3& point = _mesh.point(vertex);
            mesh.grid.push_back(LeafTerrain::gridOf(tile, point));
            mesh.vertices.push_back(meshVertex(point, mesh.grid.back(), mesh.stepM));
            return slots[vertex] = static_cast<std::uint32_t>(mesh.grid.size() - 1);
        };
        for (const DrawnBisector& t : _mesh.drawn())
            mesh.triangles.push_back({{slotOf(t.vertices[0]), slotOf(t.vertices[1]), slotOf(t.vertices[2])}});
        return mesh;
    }

    std::optional<LeafOrder> order() const override { return orderOf(drawn()); }

    /// A split or a merge writes a triangle and every second time a vertex.
    WrittenSlots written() const override
    {
        const std::size_t changed = _changes.split + _changes.merged;
        return {2 * changed, changed / 2};
    }
    bool isValid() const override { return _mesh.tree().isConforming(); }
    std::size_t memoryBytes() const override { return 3 * trianglesOfBintrees(); }

    /// Those that can be split.
    std::size_t trianglesOfBintrees() const
    {
        const BisectionSurface& surface = _terrain->model->surface;
        return std::size_t{surface.mesh().sides()} << surface.levels();
    }

private:
    std::shared_ptr<const LeafTerrain> _terrain;
    BisectionMesh _mesh;
    BisectionChanges _changes;
    std::uint32_t _leaves = 4; ///< of the bintrees
};

} // namespace

std::optional<Rival> tinLeavesRival(const std::shared_ptr<const RoamTile>& tile, double errorM)
{
    const TileGrid& grid = tile->tile.grid();
    const int cells = grid.dataColumns() - 1;
    if (grid.exponent() != 0 || grid.dataRows() != cells + 1 || cells < kSquareCells || cells > kMostCells ||
        !std::has_single_bit(static_cast<unsigned>(cells)))
        return std::nullopt;
    constexpr std::size_t kSharedBytes = 24 + 8; // places and bounds, for each triangle of the bintrees
    const double begin = measurement::processorMs();
    const auto terrain = terrainOf(tile, errorM);
    Rival rival;
    rival.name = "tin-leaves";
    rival.keepsCeiling = false;
    rival.newMesh = [terrain] { return std::make_unique<LeafMesh>(terrain); };
    rival.sharedBytes = kSharedBytes * LeafMesh(terrain).trianglesOfBintrees();
    rival.preparationS = 1e-3 * (measurement::processorMs() - begin);
    return rival;
}

} // namespace terraintool
