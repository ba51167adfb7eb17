// SPDX-License-Identifier: Apache-2.0
#include <cmath>
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

#include "terminal/Terminal.h"
#include "terraintool/mt/ForestFigures.h"
#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;

/// A surface with the place of its lattice.
struct PlacedSurface
{
    SurfaceMesh mesh;
    PlanFrame frame;
};

foundation::Result<PlacedSurface> readRasters(const MtBuildRequest& request)
{
    const auto field = osgTerrainROAM::core::importDems(request.inputs, request.import);
    if (!field) return field.error();
    PlacedSurface surface;
    surface.frame.stepX = field->spacingEastM;
    surface.frame.stepY = field->spacingNorthM;
    surface.mesh = gridSurface(field->columns, field->rows, field->heightsM);
    if (field->mask.hasAll()) return surface;
    std::vector<bool> isThere;
    for (int row = 0; row < field->rows; ++row)
        for (int column = 0; column < field->columns; ++column)
            isThere.push_back(field->mask.holds(column, row));
    dropPoints(surface.mesh, std::move(isThere));
    return surface;
}

bool isPointFile(const std::filesystem::path& file)
{
    const std::string extension = file.extension().string();
    return extension == ".csv" || extension == ".xyz" || extension == ".txt";
}

/// Tells by how much places have been moved, where that is more than a thousandth of a step.
void tellRounding(double mostMoved, const PlanFrame& frame)
{
    if (mostMoved > 1e-3 * frame.stepX) std::cout << "places are rounded by up to " << mostMoved << '\n';
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
    if (request.inputs.size() > 1)
        return foundation::Error{request.inputs[1].string(), "is one surface too many",
                                 "give one file of triangles"};
    const auto tin = readTinFile(request.inputs[0]);
    if (!tin) return tin.error();
    auto placed = placeTin(*tin, request.inputs[0].string());
    if (!placed) return placed.error();
    tellRounding(placed->mostMoved, placed->frame);
    return PlacedSurface{std::move(placed->mesh), placed->frame};
}

foundation::Result<PlacedSurface> readSurface(const MtBuildRequest& request)
{
    if (isTinFile(request.inputs[0])) return readTin(request);
    const bool arePoints = isPointFile(request.inputs[0]);
    for (const std::filesystem::path& input : request.inputs)
        if (isPointFile(input) != arePoints)
            return foundation::Error{input.string(), "stands among inputs of another kind",
                                     "give rasters, files of points, or one file of triangles"};
    return arePoints ? readPoints(request) : readRasters(request);
}

/// The memory that a build takes at most, in MB: surface and rests by point, and a tree in each thread.
double neededMb(std::size_t points, std::uint32_t trees, unsigned jobs)
{
    constexpr double kBytesOfPoint = 190.0, kBytesOfTreePoint = 500.0;
    const double all = static_cast<double>(points);
    return (kBytesOfPoint * all + kBytesOfTreePoint * jobs * all / trees) / 1e6;
}

foundation::Outcome checkMemory(const MtBuildRequest& request, std::size_t points)
{
    const std::uint32_t trees = request.options.treeCount > 0
                                    ? request.options.treeCount
                                    : balancedTreeCount(static_cast<double>(points), request.options.border);
    const double needed = neededMb(points, trees, request.options.jobs);
    if (request.memoryMb <= 0.0 || needed <= request.memoryMb) return foundation::success();
    return foundation::Error{request.output.string(),
                             "needs " + std::to_string(std::lround(std::ceil(needed))) + " MB for " +
                                 std::to_string(points) + " points",
                             "allow more with --memory, or build parts of the input by themselves"};
}

} // namespace

foundation::Result<terminal::Report> buildMt(const MtBuildRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.output); !writable) return writable.error();
    const auto surface = readSurface(request);
    if (!surface) return surface.error();
    if (const auto fault = checkInput(surface->mesh))
        return foundation::Error{request.inputs[0].string(), *fault, "repair the input"};
    if (const auto enough = checkMemory(request, surface->mesh.points.size()); !enough) return enough.error();
    ForestOptions options = request.options;
    std::optional<terminal::Progress> bar;
    options.progress = [&](std::uint32_t done, std::uint32_t all)
    {
        if (!bar) bar.emplace(request.output.string(), all - done + 1);
        bar->advance();
        return true;
    };
    const auto built = buildMtFile(surface->mesh, surface->frame, options, request.output);
    bar.reset();
    if (!built) return built.error();
    terminal::Report report;
    nlohmann::ordered_json& row = report.json["files"].emplace_back();
    row["file"] = request.output.string();
    row["points"] = surface->mesh.points.size();
    row["triangles"] = surface->mesh.triangles.size();
    addForestFigures(row, *built);
    row["fileBytes"] = std::filesystem::file_size(request.output);
    std::cout << request.output.string() << ": " << surface->mesh.points.size() << " points in "
              << built->trees << " trees, " << row["fileBytes"] << " bytes\n";
    return report;
}

} // namespace terraintool
