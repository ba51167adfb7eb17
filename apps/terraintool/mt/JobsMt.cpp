// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include <foundation/WholeFile.h>
#include <foundation/WritableFolder.h>

#include <osgMultiTriangulation/core/jobs/BuildFolder.h>

#include "terraintool/mt/BuildProgress.h"
#include "terraintool/mt/MtRequest.h"
#include "terraintool/mt/ReadSurface.h"
#include "terraintool/mt/SpoolFolder.h"

namespace terraintool
{

using osgMultiTriangulation::core::BuildFolder;

namespace
{

foundation::Outcome spoolAndPlan(const MtBuildRequest& request, const std::filesystem::path& folder,
                                 const std::filesystem::path& incoming)
{
    const auto surface = spoolSurface(request, incoming);
    if (!surface) return surface.error();
    return BuildFolder::plan(surface->spool, surface->frame, request.options, request.memoryMb, folder);
}

} // namespace

foundation::Outcome planInto(const MtBuildRequest& request, const std::filesystem::path& folder)
{
    if (const auto writable = foundation::checkFolderWritable(folder, "plan"); !writable) return writable;
    if (const auto sound = checkInputs(request); !sound) return sound;
    if (request.memoryMb > 0.0) keepHeapSmall();
    const std::filesystem::path incoming = BuildFolder::incoming(folder);
    const foundation::Outcome outcome = spoolAndPlan(request, folder, incoming);
    std::error_code ignored;
    if (!outcome) std::filesystem::remove_all(incoming, ignored);
    if (!outcome) std::filesystem::remove(folder, ignored); // where there is nothing else in it
    return outcome;
}

foundation::Result<terminal::Report> planMt(const MtBuildRequest& request)
{
    if (const auto planned = planInto(request, request.output); !planned) return planned.error();
    const auto folder = BuildFolder::open(request.output);
    if (!folder) return folder.error();
    terminal::Report report;
    nlohmann::ordered_json& plan = report.json["plans"].emplace_back();
    plan["folder"] = request.output.string();
    plan["points"] = folder->points();
    plan["triangles"] = folder->triangles();
    plan["jobs"] = folder->order().partOf.size();
    std::cout << request.output.string() << ": " << folder->points() << " points in "
              << folder->order().partOf.size() << " jobs\n";
    for (const auto& step : folder->order().steps)
    {
        plan["steps"].push_back({{"first", step.first}, {"count", step.count}});
        std::cout << step.first << '-' << step.first + step.count - 1 << '\n';
    }
    return report;
}

foundation::Result<terminal::Report> doMtJobs(const MtJobRequest& request)
{
    keepHeapSmall();
    const auto folder = BuildFolder::open(request.folder);
    if (!folder) return folder.error();
    for (const std::uint64_t job : request.jobs)
        if (const auto done = folder->doJob(job); !done) return done.error();
    return terminal::Report{};
}

foundation::Result<terminal::Report> joinMt(const MtJobRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.output); !writable) return writable.error();
    const auto folder = BuildFolder::open(request.folder);
    if (!folder) return folder.error();
    const auto built = folder->write(request.output);
    if (!built) return built.error();
    return reportOfBuild({{}, request.output, {}, {}, 0.0}, folder->points(), folder->triangles(), *built);
}

} // namespace terraintool
