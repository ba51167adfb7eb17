// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <vector>

#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "measurement/flights/BenchmarkFlight.h"
#include "terraintool/bench/BenchParts.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;

constexpr int kFrames = 60;
constexpr double kTolerancePx = 2.0;
constexpr double kFlightStepM = 4.0, kDriveStepM = 0.5;

/// The difference of two surfaces that are linear in their triangles is largest at a vertex of either.
void appendVertices(const DiamondTree& tree, std::vector<glm::dvec2>& places)
{
    for (VertexSlot v = 0; v < tree.vertexSlots(); ++v)
    {
        const DiamondPlace& place = tree.place(v);
        const bool isThere = !place.isFree() && tree.tile().tile.grid().isInData(place.column, place.row);
        if (isThere) places.emplace_back(tree.samplePosition(v));
    }
}

double largestChangePx(const DiamondTree& before, const DiamondTree& now, const viewlod::ViewState& view)
{
    std::vector<glm::dvec2> places;
    appendVertices(before, places);
    appendVertices(now, places);
    std::vector<std::optional<DrawnGround>> was(places.size()), is(places.size());
    drawnGroundAt(before, places, was);
    drawnGroundAt(now, places, is);
    double largestPx = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        if (!was[i] || !is[i]) continue;
        const double distanceM = std::max(glm::distance(is[i]->position, view.eyeWorld), view.nearM);
        const double changeM = std::abs(is[i]->position.z - was[i]->position.z);
        largestPx = std::max(largestPx, view.pixelsPerTangent * changeM / distanceM);
    }
    return largestPx;
}

double largestPopPx(const std::shared_ptr<const RoamTile>& tile, const BenchmarkFlight& flight, bool morphing)
{
    RoamMesh before(tile), now(tile); // the same eye, a frame apart
    before.setMorphing(morphing);
    now.setMorphing(morphing);
    double largestPx = 0.0;
    before.refine(flight.view(tile->tile, 0), {.errorTolerancePx = kTolerancePx});
    for (int frame = 1; frame < kFrames; ++frame)
    {
        const viewlod::ViewState view = flight.view(tile->tile, frame);
        now.refine(view, {.errorTolerancePx = kTolerancePx});
        largestPx = std::max(largestPx, largestChangePx(before.tree(), now.tree(), view));
        before.refine(view, {.errorTolerancePx = kTolerancePx});
    }
    return largestPx;
}

} // namespace

nlohmann::ordered_json measurePops(const std::shared_ptr<const RoamTile>& tile)
{
    nlohmann::ordered_json rows;
    for (const measurement::Path path : {measurement::Path::flight, measurement::Path::drive})
    {
        const double cellM = tile->tile.field().spacingEastM;
        const double stepM =
            std::min(path == measurement::Path::flight ? kFlightStepM : kDriveStepM, 0.5 * cellM);
        BenchmarkFlight flight = BenchmarkFlight::along(path);
        flight.cellsPerFrame = stepM / cellM;
        rows.push_back({{"path", measurement::pathName(path)},
                        {"stepM", stepM},
                        {"tolerancePx", kTolerancePx},
                        {"popPx", largestPopPx(tile, flight, false)},
                        {"popPxMorphed", largestPopPx(tile, flight, true)}});
    }
    return rows;
}

} // namespace terraintool
