// SPDX-License-Identifier: Apache-2.0
#include "terraintool/mt/BuildProgress.h"

#include <iostream>

#include <sys/resource.h>

#include "terraintool/mt/ForestFigures.h"

namespace terraintool
{

double peakMb()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;
}

terminal::Report reportOfBuild(const MtBuildRequest& request, std::uint64_t points, std::uint64_t triangles,
                               const osgMultiTriangulation::core::ForestReport& built)
{
    terminal::Report report;
    nlohmann::ordered_json& row = report.json["files"].emplace_back();
    row["file"] = request.output.string();
    row["points"] = points;
    row["triangles"] = triangles;
    addForestFigures(row, built);
    row["fileBytes"] = std::filesystem::file_size(request.output);
    row["peakMB"] = peakMb();
    std::cout << request.output.string() << ": " << points << " points in " << built.trees << " trees, "
              << row["fileBytes"] << " bytes\n";
    return report;
}

} // namespace terraintool
