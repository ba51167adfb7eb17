// SPDX-License-Identifier: Apache-2.0
// mt_bench: builds multi-triangulations of made-up points and measures how time and memory grow.
#include "compare/triangulations/MtBenchRequest.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"

namespace
{

int run(int argc, char** argv)
{
    CLI::App app("Builds multi-triangulations of made-up points of four distributions.", "mt_bench");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    std::filesystem::path jsonFile;
    terraintool::MtBenchRequest request;
    request.folder = std::filesystem::temp_directory_path();
    app.add_option("--points", request.points, "numbers of points")->check(CLI::Range(100, 100'000'000));
    app.add_option("--distribution", request.distribution, "one of the four alone")
        ->check(CLI::IsMember({"uniform", "normal", "laplace", "clustered"}));
    app.add_option("--memory", request.memoryMb, "MB that each build may take")
        ->check(terminal::between(1.0, 1e7));
    app.add_option("--folder", request.folder, "for the files; they are removed")
        ->check(CLI::ExistingDirectory);
    app.add_flag("--sweeps", request.hasSweeps, "sweep trees, thresholds, index instead");
    app.add_option("--jobs", request.options.jobs, "threads (1)")->check(CLI::Range(1u, 1024u));
    app.add_option("--trees", request.options.treeCount, "rectangles; without it: balanced")
        ->check(CLI::Range(1u, 1'000'000u));
    app.add_option("--json", jsonFile, "also write the table to this file");
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return terminal::report("mt_bench", jsonFile, [&] { return terraintool::benchMt(request); });
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("mt_bench", [=] { return run(argc, argv); });
}
