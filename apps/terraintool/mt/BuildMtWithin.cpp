// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <vector>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgMultiTriangulation/core/spool/GridSpool.h>
#include <osgMultiTriangulation/core/spool/InputSpool.h>
#include <osgTerrainROAM/core/heightfield/DemRows.h>

#include "terraintool/mt/BuildProgress.h"
#include "terraintool/mt/ReadSurface.h"
#include "terraintool/mt/SpoolFolder.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;

foundation::Result<PlanFrame> spoolRaster(const MtBuildRequest& request, SurfaceSpool& spool)
{
    if (request.inputs.size() > 1)
        return foundation::Error{request.inputs[1].string(), "cannot be joined within a limit of memory",
                                 "join the rasters with gdalbuildvrt, and give the .vrt file"};
    auto rows = osgTerrainROAM::core::DemRows::open(request.inputs[0], request.import);
    if (!rows) return rows.error();
    GridSpool grid(spool, rows->columns(), cutOf(request, rows->spacingEastM(), rows->spacingNorthM()));
    std::vector<float> heights(static_cast<std::size_t>(rows->columns()));
    for (int row = 0; row < rows->rows(); ++row)
    {
        if (const auto read = rows->read(row, heights); !read) return read.error();
        grid.addRow(heights);
    }
    grid.finish();
    if (grid.holes() > 0)
        std::cout << grid.holes() << " voids stay holes: to be filled they need the whole raster in memory\n";
    return frameOf(rows->spacingEastM(), rows->spacingNorthM(), rows->place());
}

/// Tells what was done to points, as a build in memory does.
void tell(const SpooledInput& input)
{
    if (input.repeated > 0) std::cout << input.repeated << " points at the place of another are left out\n";
    tellRounding(input.mostMoved, input.frame);
}

foundation::Result<PlanFrame> spoolInput(const MtBuildRequest& request, SurfaceSpool& spool)
{
    const bool isTin = isTinFile(request.inputs[0]);
    if (!isTin && !isPointFile(request.inputs[0])) return spoolRaster(request, spool);
    const auto input =
        isTin ? spoolTinFile(request.inputs[0], spool) : spoolPointFiles(request.inputs, spool);
    if (!input) return input.error();
    tell(*input);
    return input->frame;
}

/// Reads the surface at once, checks it, and puts it into a spool.
foundation::Result<PlanFrame> spoolAtOnce(const MtBuildRequest& request, SurfaceSpool& spool)
{
    const auto surface = readSurface(request);
    if (!surface) return surface.error();
    for (const SurfacePoint& point : surface->mesh.points)
        spool.addPoint(point);
    for (const Triangle& triangle : surface->mesh.triangles)
        spool.addTriangle(triangle);
    return surface->frame;
}

} // namespace

foundation::Result<SpooledSurface> spoolSurface(const MtBuildRequest& request,
                                                const std::filesystem::path& folder)
{
    auto spool = SurfaceSpool::create(folder);
    if (!spool) return spool.error();
    const auto frame = request.memoryMb > 0.0 ? spoolInput(request, *spool) : spoolAtOnce(request, *spool);
    if (!frame) return frame.error();
    if (const auto whole = spool->finish(); !whole) return whole.error();
    if (spool->triangles().size() == 0)
        return foundation::Error{request.inputs[0].string(), "has no triangle", "give a surface"};
    return SpooledSurface{std::move(*spool), *frame};
}

foundation::Result<terminal::Report> buildMtWithin(const MtBuildRequest& request)
{
    keepHeapSmall();
    const SpoolFolder folder(request.output);
    const auto surface = spoolSurface(request, folder.path());
    if (!surface) return surface.error();
    BuildProgress progress(request);
    const auto built =
        buildMtFile(surface->spool, surface->frame, progress.options(), request.memoryMb, request.output);
    progress.end();
    if (!built) return built.error();
    return reportOfBuild(request, surface->spool.points().size(), surface->spool.triangles().size(), *built);
}

} // namespace terraintool
