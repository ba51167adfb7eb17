// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <optional>

#include <foundation/WholeFile.h>

#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/input/Delaunay.h>
#include <osgMultiTriangulation/core/input/PointSet.h>
#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgMultiTriangulation/core/surface/DropPoints.h>
#include <osgMultiTriangulation/core/surface/GridSurface.h>
#include <osgTerrainROAM/core/heightfield/DemCheck.h>

#include "terminal/Places.h"
#include "terraintool/mt/BuildProgress.h"
#include "terraintool/mt/MtRequest.h"
#include "terraintool/mt/ReadSurface.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;

foundation::Result<PlacedSurface> readRasters(const MtBuildRequest& request)
{
    std::optional<osgTerrainROAM::core::GridPlace> place;
    const auto field = osgTerrainROAM::core::importDems(request.inputs, request.import, place);
    if (!field) return field.error();
    PlacedSurface surface;
    surface.frame = frameOf(field->spacingEastM, field->spacingNorthM, place);
    surface.mesh = gridSurface(field->columns, field->rows, field->heightsM,
                               cutOf(request, field->spacingEastM, field->spacingNorthM));
    if (field->mask.hasAll()) return surface;
    std::vector<bool> isThere;
    for (int row = 0; row < field->rows; ++row)
        for (int column = 0; column < field->columns; ++column)
            isThere.push_back(field->mask.holds(column, row));
    dropPoints(surface.mesh, std::move(isThere));
    return surface;
}

foundation::Result<PlacedSurface> readPoints(const MtBuildRequest& request)
{
    std::vector<MeasuredPoint> points;
    for (const std::filesystem::path& input : request.inputs)
    {
        const auto read = readPointFile(input);
        if (!read) return read.error();
        points.insert(points.end(), read->begin(), read->end());
    }
    PlacedPoints placed = placeOnLattice(points);
    if (placed.repeated > 0) std::cout << placed.repeated << " points at the place of another are left out\n";
    tellRounding(placed.mostMoved, placed.frame);
    return PlacedSurface{delaunay(std::move(placed.points)), placed.frame};
}

foundation::Result<PlacedSurface> readTin(const MtBuildRequest& request)
{
    const auto tin = readTinFile(request.inputs[0]);
    if (!tin) return tin.error();
    auto placed = placeTin(*tin, request.inputs[0].string());
    if (!placed) return placed.error();
    tellRounding(placed->mostMoved, placed->frame);
    return PlacedSurface{std::move(placed->mesh), placed->frame};
}

foundation::Result<PlacedSurface> readUnchecked(const MtBuildRequest& request)
{
    if (isTinFile(request.inputs[0])) return readTin(request);
    return isPointFile(request.inputs[0]) ? readPoints(request) : readRasters(request);
}

} // namespace

PlanFrame frameOf(double spacingEastM, double spacingNorthM,
                  const std::optional<osgTerrainROAM::core::GridPlace>& place)
{
    PlanFrame frame{0.0, 0.0, spacingEastM, spacingNorthM};
    if (place)
        frame.reference =
            PlanReference{place->system, place->firstX, place->firstY, place->stepX, place->stepY};
    return frame;
}

CellCut cutOf(const MtBuildRequest& request, double spacingEastM, double spacingNorthM)
{
    CellCut cut{.stepX = spacingEastM, .stepY = spacingNorthM};
    cut.rule = request.diagonal.value_or(cut.rule);
    return cut;
}

foundation::Result<PlacedSurface> readSurface(const MtBuildRequest& request)
{
    auto surface = readUnchecked(request);
    if (!surface) return surface;
    if (const auto fault = checkInput(surface->mesh))
        return foundation::Error{request.inputs[0].string(), *fault, "repair the input"};
    return surface;
}

bool isPointFile(const std::filesystem::path& file)
{
    const std::string extension = file.extension().string();
    return extension == ".csv" || extension == ".xyz" || extension == ".txt";
}

void tellRounding(double mostMoved, const PlanFrame& frame)
{
    if (mostMoved > 1e-3 * frame.stepX) std::cout << "places are rounded by up to " << mostMoved << '\n';
}

foundation::Outcome checkInputs(const MtBuildRequest& request)
{
    const bool areTriangles = isTinFile(request.inputs[0]), arePoints = isPointFile(request.inputs[0]);
    if (areTriangles && request.inputs.size() > 1)
        return foundation::Error{request.inputs[1].string(), "is one surface too many",
                                 "give one file of triangles"};
    for (const std::filesystem::path& input : request.inputs)
        if (isPointFile(input) != arePoints || isTinFile(input) != areTriangles)
            return foundation::Error{input.string(), "stands among inputs of another kind",
                                     "give rasters, files of points, or one file of triangles"};
    if (request.diagonal && (areTriangles || arePoints))
        return foundation::Error{request.inputs[0].string(), "has no cells that --quad-diagonal could cut",
                                 "leave the option out, or give rasters"};
    if (!areTriangles && !arePoints) return osgTerrainROAM::core::checkDems(request.inputs, request.import);
    return terminal::checkPlaces({{}, {}, request.inputs});
}

foundation::Result<terminal::Report> buildMt(const MtBuildRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.output); !writable) return writable.error();
    if (const auto sound = checkInputs(request); !sound) return sound.error();
    if (request.memoryMb > 0.0) return buildMtWithin(request);
    const auto surface = readSurface(request);
    if (!surface) return surface.error();
    BuildProgress progress(request);
    const auto built = buildMtFile(surface->mesh, surface->frame, progress.options(), request.output);
    progress.end();
    if (!built) return built.error();
    return reportOfBuild(request, surface->mesh.points.size(), surface->mesh.triangles.size(), *built);
}

} // namespace terraintool
