// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <memory>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "terminal/Terminal.h"
#include "terraintool/Commands.h"
#include "terraintool/TourViews.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// What all frames of one file's flight add up to.
struct Flight
{
    std::size_t tJunctions = 0;
    std::size_t cracks = 0;
    std::size_t ceilingExceeded = 0; ///< frames with more leaves than allowed
    std::size_t toleranceExceeded = 0;
    double maxErrorPx = 0.0;
    double tolerancePx = 0.0; ///< the largest that a frame reached

    bool sound() const { return tJunctions + cracks + ceilingExceeded + toleranceExceeded == 0; }
};

void checkFrame(RoamMesh& mesh, const viewlod::ViewState& view, const viewlod::Budget& budget, Flight& flight)
{
    const RefineResult result = mesh.refine(view, budget);
    std::vector<TriangleRange> everything;
    mesh.visibleRanges(viewlod::Frustum(glm::dmat4(0.0)),
                       everything); // planes without direction cull nothing
    const auto drawn = gathered(mesh.triangles(), everything);
    const DrawnMeshReport report = checkDrawnMesh(mesh.tile(), mesh.vertices(), drawn, &view);
    flight.tJunctions += report.tJunctions;
    flight.cracks += report.cracks;
    flight.ceilingExceeded += result.leaves > budget.maxTriangles ? 1 : 0;
    flight.toleranceExceeded += report.maxErrorPx > result.tolerancePx ? 1 : 0;
    flight.maxErrorPx = std::max(flight.maxErrorPx, report.maxErrorPx);
    flight.tolerancePx = std::max(flight.tolerancePx, result.tolerancePx);
}

viewlod::Result<Flight> fly(const Request& request, const std::string& file, nlohmann::ordered_json& row)
{
    const auto description = describeTerrain(file, request.import);
    if (!description) return description.error();
    auto placed = loadTile(*description);
    if (!placed) return placed.error();
    row["samples"] = placed->field().heightsM.size();
    row["voids"] = placed->field().voids.count;
    const auto views = tourViews(*placed, request.frames);
    if (!views) return views.error();

    RoamMesh mesh(std::make_shared<const RoamTile>(std::move(*placed)));
    Flight flight;
    terminal::Progress progress(file, views->size());
    for (const viewlod::ViewState& view : *views)
    {
        checkFrame(mesh, view,
                   {.errorTolerancePx = request.tolerancePx, .maxTriangles = request.maxTriangles}, flight);
        progress.advance();
    }
    return flight;
}

} // namespace

viewlod::Result<Report> validate(const Request& request)
{
    Report report;
    for (const std::string& file : request.files)
    {
        nlohmann::ordered_json row;
        row["file"] = file;
        const auto flight = fly(request, file, row);
        if (!flight) return flight.error();
        row["frames"] = request.frames;
        row["tJunctions"] = flight->tJunctions;
        row["cracks"] = flight->cracks;
        row["maxErrorPx"] = flight->maxErrorPx;
        row["tolerancePx"] = flight->tolerancePx;
        row["ceilingExceeded"] = flight->ceilingExceeded;
        row["toleranceExceeded"] = flight->toleranceExceeded;
        report.sound = report.sound && flight->sound();
        std::cout << (flight->sound() ? "sound  " : "BROKEN ") << row.dump() << '\n';
        report.json["files"].push_back(std::move(row));
    }
    return report;
}

} // namespace terraintool
