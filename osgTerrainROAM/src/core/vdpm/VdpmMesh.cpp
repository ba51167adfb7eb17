// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <osgTerrainROAM/core/roam/NearestSurface.h>
#include <osgTerrainROAM/core/vdpm/VdpmMesh.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr int kMostTolerances = 40;       ///< that a frame tries at a ceiling
constexpr std::uint8_t kMorphFrames = 16; ///< that a vertex moves
constexpr double kMorphShare = 0.75;      ///< of the tolerance, at which a vertex begins to move

/// Narrows the tolerance at which a mesh just fits under a ceiling.
struct ToleranceBracket
{
    double tooFinePx = 0.0, fittingPx = std::numeric_limits<double>::infinity();

    /// The next tolerance to try. `ratio`: faces wanted over the faces aimed at; their number falls about as
    /// the tolerance rises.
    double next(double tolerancePx, double ratio) const
    {
        const double guess = tolerancePx * std::clamp(ratio, 0.25, 4.0);
        if (guess > tooFinePx && guess < fittingPx) return guess;
        return std::isinf(fittingPx) ? 2.0 * tooFinePx : std::sqrt(tooFinePx * fittingPx);
    }
};

} // namespace

VdpmMesh::VdpmMesh(std::shared_ptr<const RoamTile> tile, std::shared_ptr<const BoundedForest> forest)
    : _tile(std::move(tile)), _forest(std::move(forest)), _driver(*_forest)
{
}

void VdpmMesh::setSight(const viewlod::Sight& sight)
{
    if (sight.isEverything() != _sight.isEverything()) _driver.forget();
    _sight = sight;
}

/// Runs the driver at the lowest tolerance that the ceiling allows, within 1 %. A mesh that was at the
/// ceiling starts with its last tolerance. Returns false when the slice has ended before.
bool VdpmMesh::runWithinCeiling(const viewlod::ViewState& view, const viewlod::Budget& budget,
                                viewlod::Slice& slice, RefineResult& result)
{
    const std::uint32_t most = budget.maxTriangles, unused = std::max(most / 100, 4u);
    const double aim = most - 0.5 * unused,
                 targetPx = budget.errorTolerancePx * (_isMorphing ? kMorphShare : 1.0);
    ToleranceBracket bracket;
    double tolerancePx = _ceilingBound ? std::max(_lastTolerancePx, targetPx) : targetPx;
    for (int attempt = 0;; ++attempt)
    {
        result.tolerancePx = tolerancePx;
        // Under a ceiling, and in the first frame, vertices jump.
        const bool moves = _isMorphing && _hasRefined && !_ceilingBound && attempt == 0;
        _driver.setMorph(moves ? kMorphFrames : 0, budget.errorTolerancePx);
        const SplitCriterion criterion(view, tolerancePx, {.sight = _sight});
        const bool finished = _driver.refine(criterion, most, slice, result);
        result.errorBoundPx = _driver.errorBoundPx(criterion);
        if (slice.isSpent() && !finished) return false;
        const std::uint32_t faces = _driver.front().faceCount();
        const bool fits = finished && faces <= most;
        if (fits && (tolerancePx <= targetPx || faces + unused >= most)) return true;
        if (!fits && faces == _forest->forest.rootFaces.size())
            return true; // the base is more than the ceiling
        if (attempt >= kMostTolerances && fits) return true;
        (fits ? bracket.fittingPx : bracket.tooFinePx) = tolerancePx;
        const double wanted = faces + 2.0 * static_cast<double>(_driver.waiting());
        tolerancePx = attempt >= kMostTolerances && std::isfinite(bracket.fittingPx)
                          ? bracket.fittingPx
                          : std::max(bracket.next(tolerancePx, wanted / aim), targetPx);
    }
}

RefineResult VdpmMesh::refine(const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    _driver.clearChanges();
    RefineResult result;
    viewlod::Slice slice(budget);
    result.sliceBound = !runWithinCeiling(view, budget, slice, result);
    _driver.moveVertices(SplitCriterion(view, result.tolerancePx, {.sight = _sight}), result);
    _ceilingBound = result.tolerancePx > budget.errorTolerancePx * (_isMorphing ? kMorphShare : 1.0);
    _hasRefined = true;
    result.ceilingBound = _ceilingBound && !result.sliceBound;
    _lastTolerancePx = result.tolerancePx;
    if (_isMorphing) // until it is done, what moves may be off by the whole tolerance
    {
        result.tolerancePx = std::max(result.tolerancePx, budget.errorTolerancePx);
        result.errorBoundPx = std::max(result.errorBoundPx, result.tolerancePx);
    }
    _driver.trimChanges();
    result.triangles = result.leaves = _driver.front().faceCount();
    return result;
}

RefineResult VdpmMesh::refine(double errorM)
{
    _driver.clearChanges();
    _driver.forget();
    _driver.setMorph(0, 0.0);
    RefineResult result;
    viewlod::Slice unlimited({});
    _driver.refine(SplitCriterion(errorM), std::numeric_limits<std::uint32_t>::max(), unlimited, result);
    _driver.forget();
    _driver.trimChanges();
    result.triangles = result.leaves = _driver.front().faceCount();
    return result;
}

/// The place of the vertex in a slot; that of a free slot is any.
GridPoint VdpmMesh::gridAt(std::uint32_t slot) const
{
    const std::uint32_t vertex = _driver.front().vertexAt(slot);
    if (vertex == kNone) return {};
    const PlacedTile& tile = _tile->tile;
    const auto columns = static_cast<std::uint32_t>(tile.field().columns);
    const std::uint32_t sample = _forest->forest.original[vertex];
    return {static_cast<int>(sample % columns) << tile.grid().exponent(), static_cast<int>(sample / columns)
                                                                              << tile.grid().exponent()};
}

/// The place at which the vertex in a slot is drawn. What it moves away from stays: only one of two
/// neighbours moves.
glm::dvec3 VdpmMesh::positionAt(std::uint32_t slot) const
{
    const std::uint32_t vertex = _driver.front().vertexAt(slot);
    const glm::dvec3& place = _forest->positions[vertex];
    const float weight = _driver.weightOf(vertex);
    if (weight == 1.0f) return place;
    const VertexForest& forest = _forest->forest;
    return glm::mix(_forest->positions[forest.splits[forest.makerOfVertex(vertex)].v1], place,
                    double(weight));
}

void VdpmMesh::appendVertices(IndexRange slots, std::vector<MeshVertex>& vertices) const
{
    const double stepM = _tile->tile.frame().vertexStepM();
    for (std::uint32_t slot = slots.first; slot < slots.first + slots.count; ++slot)
        vertices.push_back(_driver.front().vertexAt(slot) == kNone
                               ? MeshVertex{}
                               : meshVertex(positionAt(slot), gridAt(slot), stepM));
}

void VdpmMesh::appendTriangles(IndexRange slots, std::vector<LeafTriangle>& triangles) const
{
    for (std::uint32_t slot = slots.first; slot < slots.first + slots.count; ++slot)
    {
        const auto& corners = _driver.front().faceAt(slot).corners;
        triangles.push_back({{corners[0], corners[1], corners[2]}});
    }
}

std::uint32_t VdpmMesh::visibleRanges(const viewlod::Frustum&, std::vector<IndexRange>& ranges) const
{
    ranges.push_back({0, triangleSlots()});
    return triangleSlots();
}

std::uint32_t VdpmMesh::visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3&, const Horizon*,
                                      std::vector<IndexRange>& ranges) const
{
    return visibleRanges(frustum, ranges);
}

DrawnMesh VdpmMesh::drawn(std::span<const IndexRange> ranges) const
{
    DrawnMesh mesh;
    mesh.isMorphed = _isMorphing;
    mesh.stepM = _tile->tile.frame().vertexStepM();
    appendVertices({0, vertexSlots()}, mesh.vertices);
    for (std::uint32_t slot = 0; slot < vertexSlots(); ++slot)
        mesh.grid.push_back(gridAt(slot));
    for (const IndexRange& range : ranges)
        appendTriangles(range, mesh.triangles);
    return mesh;
}

double VdpmMesh::nearestM(const glm::dvec3& point) const
{
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t slot = 0; slot < triangleSlots(); ++slot)
    {
        const auto& corners = _driver.front().faceAt(slot).corners;
        const std::array at{positionAt(corners[0]), positionAt(corners[1]), positionAt(corners[2])};
        // The triangle lies in the ball around its first corner; most are far away.
        const double size = std::sqrt(
            std::max(glm::dot(at[1] - at[0], at[1] - at[0]), glm::dot(at[2] - at[0], at[2] - at[0])));
        const glm::dvec3 off = at[0] - point;
        if (glm::dot(off, off) < (least + size) * (least + size))
            least = std::min(least, distanceToTriangleM(point, at));
    }
    return least;
}

void VdpmMesh::forEachTriangleAtBorder(const BorderVisit& visit) const
{
    for (std::uint32_t slot = 0; slot < triangleSlots(); ++slot)
    {
        const ActiveFront::Face& f = _driver.front().faceAt(slot);
        if (std::ranges::find(f.across, kNone) == f.across.end()) continue;
        const GridPoint corners[3]{gridAt(f.corners[0]), gridAt(f.corners[1]), gridAt(f.corners[2])};
        visit(corners, {{f.corners[0], f.corners[1], f.corners[2]}});
    }
}

} // namespace osgTerrainROAM::core
