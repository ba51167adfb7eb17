// SPDX-License-Identifier: Apache-2.0
// terraintool-mpi: builds a multi-triangulation over the ranks of MPI, each a process on any host that sees
// the folder of the output.
#include <foundation/WholeFile.h>
#include <mpi.h>

#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "terraintool/mpi/RankBuild.h"
#include "terraintool/mt/AddMtCommands.h"
#include "terraintool/mt/BuildProgress.h"
#include "terraintool/mt/SpoolFolder.h"

namespace
{

using osgMultiTriangulation::core::BuildFolder;

foundation::Result<BuildFolder> planned(const terraintool::MtBuildRequest& request,
                                        const std::filesystem::path& folder)
{
    if (const auto writable = foundation::checkWritable(request.output); !writable) return writable.error();
    if (const auto plan = terraintool::planInto(request, folder); !plan) return plan.error();
    return BuildFolder::open(folder);
}

/// What rank 0 does: plans, hands out, joins.
foundation::Result<terminal::Report> lead(const terraintool::MtBuildRequest& request,
                                          const std::filesystem::path& folder)
{
    const auto jobs = planned(request, folder);
    if (!jobs)
    {
        terraintool::dismissRanks();
        return jobs.error();
    }
    terraintool::BuildProgress progress(request);
    const auto done = terraintool::handOutJobs(*jobs, progress.options().progress);
    progress.end();
    if (!done) return done.error();
    const auto built = jobs->write(request.output);
    if (!built) return built.error();
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    return terraintool::reportOfBuild(request, jobs->points(), jobs->triangles(), *built);
}

int run(int argc, char** argv)
{
    CLI::App app("Builds a multi-triangulation over ranks of MPI: mpirun -n N terraintool-mpi …",
                 "terraintool-mpi");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    terraintool::MtBuildRequest request;
    std::filesystem::path jsonFile;
    terraintool::addMtBuildOptions(app, request, jsonFile);
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    MPI_Init(&argc, &argv);
    int rank = 0, code = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    std::filesystem::path folder = request.output;
    folder += ".jobs";
    if (rank == 0)
        code = terminal::report("terraintool-mpi", jsonFile, [&] { return lead(request, folder); });
    else
    {
        terraintool::keepHeapSmall();
        terraintool::serveRank(folder);
    }
    MPI_Finalize();
    return code;
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("terraintool-mpi", [=] { return run(argc, argv); });
}
