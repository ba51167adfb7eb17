// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "compare/terrain/drivers/BenchParts.h"
#include "compare/terrain/drivers/FrameChange.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;

constexpr int kFrames = 60;
constexpr double kTolerancePx = 2.0;
constexpr double kFlightStepM = 4.0, kDriveStepM = 0.5;

double largestPopPx(const std::shared_ptr<const RoamTile>& tile, const BenchmarkFlight& flight, bool morphing)
{
    RoamMesh mesh(tile);
    mesh.setMorphing(morphing);
    double largestPx = 0.0;
    mesh.refine(flight.view(tile->tile, 0), {.errorTolerancePx = kTolerancePx});
    DrawnMesh before = mesh.drawn();
    for (int frame = 1; frame < kFrames; ++frame)
    {
        const viewlod::ViewState view = flight.view(tile->tile, frame);
        mesh.refine(view, {.errorTolerancePx = kTolerancePx});
        DrawnMesh now = mesh.drawn();
        largestPx = std::max(largestPx, changeBetween(tile->tile, before, now, view).popPx);
        before = std::move(now);
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
