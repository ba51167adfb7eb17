// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/MtRival.h"

#include <utility>
#include <vector>

#include <foundation/Threads.h>

#include <osgMultiTriangulation/core/extract/Extraction.h>
#include <osgMultiTriangulation/core/extract/EyeCriterion.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgMultiTriangulation/core/surface/GridSurface.h>

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;
namespace mt = osgMultiTriangulation::core;

/// A forest, and where its lattice lies in the tile.
struct PlacedForest
{
    std::shared_ptr<const RoamTile> tile;
    mt::Forest forest;
    glm::dvec3 origin{0.0}; ///< of the criterion's frame: sample (0, 0), without its height
    glm::dvec2 stepM{1.0};
};

PlacedForest forestOf(const std::shared_ptr<const RoamTile>& tile)
{
    const PlacedTile& placed = tile->tile;
    const int columns = placed.field().columns, rows = placed.field().rows, shift = placed.grid().exponent();
    std::vector<float> heights;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            heights.push_back(placed.samples().heightM(column << shift, row << shift));
    mt::ForestOptions options;
    options.jobs = static_cast<unsigned>(foundation::processors());
    auto built = mt::buildForest(mt::gridSurface(columns, rows, heights), options); // nothing stops it
    PlacedForest made{tile, std::move(built->forest)};
    const glm::dvec3 corner = placed.position(0, 0);
    made.origin = corner - glm::dvec3(0.0, 0.0, heights.front());
    made.stepM = glm::dvec2(placed.position(1 << shift, 1 << shift) - corner);
    return made;
}

/// An extraction that follows an eye, and draws its triangles in the order in which it keeps them.
class ExtractedMesh final : public RivalMesh
{
public:
    explicit ExtractedMesh(std::shared_ptr<const PlacedForest> placed)
        : _placed(std::move(placed)), _extraction(_placed->forest.trees.front())
    {
        for (std::uint32_t tree = 1; tree < _placed->forest.trees.size(); ++tree)
            _extraction.attach(tree, _placed->forest.trees[tree]);
    }

    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override
    {
        const std::uint64_t before = _extraction.changes();
        _extraction.update(
            mt::EyeCriterion{.eye = view.eyeWorld - _placed->origin,
                             .step = _placed->stepM,
                             .errorPerDistance = budget.errorTolerancePx / view.guaranteedPixelsPerTangent(),
                             .nearest = view.nearM});
        _changed = static_cast<std::size_t>(_extraction.changes() - before);
        RefineResult result;
        result.triangles = result.leaves = static_cast<std::uint32_t>(_extraction.active().size());
        result.tolerancePx = result.errorBoundPx = budget.errorTolerancePx;
        return result;
    }

    DrawnMesh drawn() const override
    {
        const PlacedTile& tile = _placed->tile->tile;
        const int shift = tile.grid().exponent();
        const mt::SurfaceMesh surface = _extraction.mesh();
        DrawnMesh mesh;
        mesh.stepM = tile.frame().vertexStepM();
        for (const mt::SurfacePoint& p : surface.points)
        {
            mesh.grid.push_back({p.x << shift, p.y << shift});
            const glm::dvec3 place(_placed->stepM.x * p.x, _placed->stepM.y * p.y, p.height);
            mesh.vertices.push_back(meshVertex(_placed->origin + place, mesh.grid.back(), mesh.stepM));
        }
        for (const mt::Triangle& t : surface.triangles)
            mesh.triangles.push_back({{t[0], t[1], t[2]}});
        return mesh;
    }

    std::optional<LeafOrder> order() const override { return orderOf(drawn()); }

    /// A fragment comes or goes with some six triangles and one vertex.
    WrittenSlots written() const override { return {6 * _changed, _changed}; }
    bool isValid() const override { return true; }
    std::size_t memoryBytes() const override
    {
        std::size_t bytes = 0; // of the Extraction, as it says of itself
        for (const mt::ForestTree& tree : _placed->forest.trees)
            bytes += 5 * tree.part.corners.size() + tree.part.fragments.size();
        return bytes;
    }

private:
    std::shared_ptr<const PlacedForest> _placed;
    mt::Extraction _extraction;
    std::size_t _changed = 0;
};

std::size_t bytesOf(const mt::Forest& forest)
{
    std::size_t bytes = 0;
    for (const mt::ForestTree& tree : forest.trees)
        bytes += tree.part.points.size() * sizeof(mt::SurfacePoint) +
                 tree.part.corners.size() * (sizeof(mt::Triangle) + sizeof(float) + 8) +
                 tree.part.fragments.size() * sizeof(mt::Fragment) +
                 tree.part.floors.size() * sizeof(std::uint32_t);
    return bytes;
}

} // namespace

Rival multiTriangulationRival(const std::shared_ptr<const RoamTile>& tile)
{
    const auto placed = std::make_shared<const PlacedForest>(forestOf(tile));
    Rival rival;
    rival.name = "multi-triangulation";
    rival.keepsCeiling = false;
    rival.sharedBytes = bytesOf(placed->forest);
    rival.parts = placed->forest.trees.size();
    rival.newMesh = [placed] { return std::make_unique<ExtractedMesh>(placed); };
    return rival;
}

} // namespace terraintool
