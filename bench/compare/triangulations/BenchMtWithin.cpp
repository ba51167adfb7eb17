// SPDX-License-Identifier: Apache-2.0
#include "compare/triangulations/BenchMtWithin.h"

#include <chrono>
#include <fstream>
#include <iostream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/spool/InputSpool.h>

#include "terraintool/mt/ForestFigures.h"
#include "terraintool/mt/SpoolFolder.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;

double secondsOf(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// What the process does that is limited.
foundation::Result<nlohmann::ordered_json> buildWithin(PointDistribution distribution, std::size_t count,
                                                       const MtBenchRequest& request,
                                                       const std::filesystem::path& file)
{
    keepHeapSmall();
    const SpoolFolder folder(file);
    auto spool = SurfaceSpool::create(folder.path());
    if (!spool) return spool.error();
    const auto input = spoolPoints(
        [&](const auto& visit) -> foundation::Outcome
        {
            streamMadeUpPoints(distribution, count,
                               [&](const SurfacePoint& p) {
                                   visit({double(p.x), double(p.y), p.height});
                               });
            return foundation::success();
        },
        *spool);
    if (!input) return input.error();
    if (const auto whole = spool->finish(); !whole) return whole.error();
    const auto built = buildMtFile(*spool, input->frame, request.options, request.memoryMb, file);
    if (!built) return built.error();
    nlohmann::ordered_json row;
    row["points"] = spool->points().size();
    addForestFigures(row, *built);
    row["inputMB"] = static_cast<double>(spool->points().size() * sizeof(SurfacePoint) +
                                         spool->triangles().size() * sizeof(Triangle)) /
                     1e6;
    return row;
}

/// Runs in the process that is limited. Never returns.
[[noreturn]] void runLimited(PointDistribution distribution, std::size_t count, const MtBenchRequest& request,
                             const std::filesystem::path& file, const std::filesystem::path& table)
{
    const auto bytes = static_cast<rlim_t>(request.memoryMb * 1e6);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_DATA, &limit);
    const auto row = buildWithin(distribution, count, request, file);
    if (row)
        std::ofstream(table) << *row;
    else
        std::cerr << row.error().message() << '\n';
    std::cerr.flush();
    _exit(row ? 0 : 1);
}

} // namespace

foundation::Result<nlohmann::ordered_json> benchCaseWithin(const std::string& name,
                                                           PointDistribution distribution, std::size_t count,
                                                           const MtBenchRequest& request)
{
    const std::filesystem::path file = request.folder / (name + std::to_string(count) + ".mt");
    std::filesystem::path table = file;
    table += ".json";
    const auto before = std::chrono::steady_clock::now();
    std::cout.flush();
    const pid_t process = fork();
    if (process == 0) runLimited(distribution, count, request, file, table);
    int status = 0;
    rusage usage{};
    if (process < 0 || wait4(process, &status, 0, &usage) != process || status != 0)
        return foundation::Error{name + " with " + std::to_string(count) + " points",
                                 "could not be built within the limit", "allow more with --memory"};
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - before;
    nlohmann::ordered_json row{{"distribution", name}};
    row.update(nlohmann::ordered_json::parse(std::ifstream(table)));
    row["buildMs"] = spent.count();
    row["processorMs"] = 1e3 * (secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime));
    row["peakMB"] = static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;
    row["limitMB"] = request.memoryMb;
    row["fileBytes"] = std::filesystem::file_size(file);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    std::filesystem::remove(table, ignored);
    return row;
}

} // namespace terraintool
