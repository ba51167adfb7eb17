// SPDX-License-Identifier: Apache-2.0
#include "terraintool/mt/ExtractMt.h"

#include <iostream>

#include <foundation/WholeFile.h>

#include <osgMultiTriangulation/core/output/WriteTin.h>

namespace terraintool
{

using namespace osgMultiTriangulation::core;

namespace
{

foundation::Outcome writeSurface(const MtExtractRequest& request, const SurfaceMesh& mesh,
                                 const PlanFrame& plan)
{
    if (!request.tile) return writeTin(request.output, mesh, request.inReference ? inReference(plan) : plan);
    const auto bytes = quantizedMeshOf(mesh, plan, *request.tile, request.file.string());
    if (!bytes) return bytes.error();
    return foundation::writeWholeFile(request.output, *bytes);
}

} // namespace

foundation::Result<terminal::Report> extractMt(const MtExtractRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.output); !writable) return writable.error();
    const auto file = MtFile::open(request.file);
    if (!file) return file.error();
    const PlanFrame& plan = file->info().frame;
    if (request.inReference && !plan.reference)
        return foundation::Error{request.file.string(), "has no georeference", "leave --places out"};
    if ((request.output.extension() == ".terrain") != request.tile.has_value())
        return foundation::Error{request.output.string(),
                                 request.tile ? "is no tile of the Earth" : "is a tile of the Earth",
                                 request.tile ? "name it .terrain, or leave --tile out"
                                              : "say which with --tile LEVEL/COLUMN/ROW, as 9/535/386"};
    const auto surface = extractFrom(*file, request.what);
    if (!surface) return surface.error();
    if (const auto written = writeSurface(request, surface->mesh, plan); !written) return written.error();
    terminal::Report report;
    report.json["files"].push_back({{"file", request.output.string()},
                                    {"points", surface->mesh.points.size()},
                                    {"triangles", surface->mesh.triangles.size()},
                                    {"errorM", surface->errorM},
                                    {"trees", surface->trees},
                                    {"ofTrees", file->info().trees.size()}});
    std::cout << request.output.string() << ": " << surface->mesh.triangles.size() << " triangles, error "
              << surface->errorM << " m, from " << surface->trees << " of " << file->info().trees.size()
              << " trees\n";
    return report;
}

nlohmann::ordered_json describeMt(const MtFile& file)
{
    const MtInfo& info = file.info();
    const MtEntry& main = info.trees[0];
    const PlanFrame& frame = info.frame;
    const PlanFrame places = inReference(frame);
    nlohmann::ordered_json system; // null: no georeference
    if (frame.reference) system = frame.reference->system.empty() ? "plane" : nameOf(*frame.reference);
    std::uint64_t bytes = 0;
    for (const MtEntry& tree : info.trees)
        bytes += tree.bytes;
    return {{"file", file.path().string()},
            {"version", file.version()},
            {"points", info.points},
            {"triangles", info.triangles},
            {"trees", info.trees.size()},
            {"mainPart", main.points},
            {"coarsestTriangles", main.rootTriangles},
            {"coarsestErrorM", main.rootError},
            {"stepX", frame.stepX},
            {"stepY", frame.stepY},
            {"heightStepM", info.heightStep},
            {"system", system},
            {"west", places.originX + places.stepX * main.low[0]},
            {"south", places.originY + places.stepY * main.low[1]},
            {"east", places.originX + places.stepX * main.high[0]},
            {"north", places.originY + places.stepY * main.high[1]},
            {"treeBytes", bytes}};
}

} // namespace terraintool
