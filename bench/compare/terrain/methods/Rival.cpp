// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/Rival.h"

#include <utility>

#include <osgTerrainROAM/core/blocks/BlockGrid.h>
#include <osgTerrainROAM/core/method/PrepareTerrain.h>
#include <osgTerrainROAM/core/roam/LeafOrder.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "compare/terrain/drivers/Measured.h"
#include "compare/terrain/methods/MtRival.h"
#include "measurement/ProcessorTime.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// Of all threads of the program.
double processorS()
{
    return 1e-3 * measurement::processorMs();
}

/// A mesh of one of the methods that draw terrains.
class MethodMesh final : public RivalMesh
{
public:
    MethodMesh(std::unique_ptr<TerrainMesh> mesh, bool morphs) : _mesh(std::move(mesh)), _morphs(morphs) {}

    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override
    {
        return _mesh->refine(view, budget);
    }
    DrawnMesh drawn() const override { return _mesh->drawn(); }
    std::optional<LeafOrder> order() const override { return orderOf(*_mesh); }
    bool setMorphing(bool on) override
    {
        _mesh->setMorphing(on && _morphs);
        return _morphs;
    }
    WrittenSlots written() const override
    {
        return {_mesh->changes().triangles.size(), _mesh->changes().vertices.size()};
    }
    std::optional<std::uint32_t> trianglesIn(const viewlod::Frustum& frustum) const override
    {
        std::vector<IndexRange> ranges;
        return _mesh->visibleRanges(frustum, ranges);
    }
    bool isValid() const override { return _mesh->isValid(); }
    std::size_t memoryBytes() const override { return _mesh->memoryBytes(); }

private:
    std::unique_ptr<TerrainMesh> _mesh;
    bool _morphs;
};

/// The leaves of the bintree, found anew for each eye.
class ScratchMesh final : public RivalMesh
{
public:
    explicit ScratchMesh(SplitBounds bounds) : _bounds(std::move(bounds)) {}

    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override
    {
        refineFromScratch(_bounds, view, budget.errorTolerancePx, _leaves);
        RefineResult result;
        result.triangles = result.leaves = static_cast<std::uint32_t>(_leaves.size());
        result.tolerancePx = result.errorBoundPx = budget.errorTolerancePx;
        return result;
    }
    DrawnMesh drawn() const override { return meshOfLeaves(_bounds, _leaves); }
    std::optional<LeafOrder> order() const override { return std::nullopt; }
    WrittenSlots written() const override { return {_leaves.size(), 3 * _leaves.size()}; }
    bool isValid() const override { return true; }
    std::size_t memoryBytes() const override { return _leaves.capacity() * sizeof(GridTriangle); }

private:
    SplitBounds _bounds;
    std::vector<GridTriangle> _leaves;
};

foundation::Result<Rival> prepareRival(const MethodTraits& traits,
                                       const std::shared_ptr<const RoamTile>& tile)
{
    const double begin = processorS();
    auto prepared = prepareTerrain(tile, {.method = traits.method}, tile->tile.field().name);
    if (!prepared) return prepared.error();
    Rival rival;
    rival.name = traits.name;
    rival.isOfBlocks = traits.method == Method::regularDecimation || traits.method == Method::vipmLocked ||
                       traits.method == Method::vipmOverlapping;
    if (rival.isOfBlocks) rival.parts = BlockGrid(tile->tile.grid()).count();
    rival.fewestTriangles = (*prepared)->fewestTriangles();
    rival.stopsInTime = traits.stopsInTime;
    rival.preparationS = processorS() - begin;
    rival.sharedBytes = (*prepared)->memoryBytes();
    rival.drawnBy = traits.method;
    rival.prepared = *prepared;
    rival.newMesh = [shared = *prepared, morphs = traits.morphs]
    { return std::make_unique<MethodMesh>(shared->newMesh(), morphs); };
    return rival;
}

} // namespace

foundation::Result<Rivals> prepareRivals(const HeightField& square)
{
    const double begin = processorS();
    Rivals rivals{std::make_shared<RoamTile>(PlacedTile(square, Placement::planar)), {}};
    const double tileS = processorS() - begin;
    for (const MethodTraits& traits : kMethods)
    {
        auto rival = prepareRival(traits, rivals.tile);
        if (!rival) return rival.error();
        rivals.all.push_back(std::move(*rival));
    }
    const double forestBegin = processorS();
    rivals.all.push_back(multiTriangulationRival(rivals.tile));
    rivals.all.back().preparationS = processorS() - forestBegin;
    Rival scratch;
    scratch.name = "scratch";
    scratch.keepsCeiling = false;
    scratch.newMesh = [bounds = SplitBounds(rivals.tile)] { return std::make_unique<ScratchMesh>(bounds); };
    rivals.all.push_back(std::move(scratch));
    for (Rival& rival : rivals.all)
        rival.preparationS += tileS;
    return rivals;
}

} // namespace terraintool
