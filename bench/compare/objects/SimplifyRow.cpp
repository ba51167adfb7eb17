// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/SimplifyRow.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "pmtool/ModelFiles.h"

namespace pmtool
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

namespace
{

/// Tells whether a count is reached, within max(1 %, 4 triangles).
bool isStuck(std::size_t reached, std::size_t target)
{
    return reached > target + std::max<std::size_t>(4, target / 100);
}

} // namespace

SimplifySubject::SimplifySubject(std::string subjectName, core::Mesh clean,
                                 std::vector<double> targetPercents)
    : name(std::move(subjectName)),
      mesh(std::move(clean)),
      shape(shapeOf(mesh)),
      meter(mesh),
      percents(std::move(targetPercents))
{
    std::sort(percents.rbegin(), percents.rend());
    for (const double percent : percents)
        targets.push_back(static_cast<std::size_t>(
            std::max(1.0, std::round(percent / 100.0 * static_cast<double>(mesh.faces.size())))));
}

void addMeasures(Json& row, const SimplifySubject& subject, const SimplifiedLevel& level, std::size_t target)
{
    const core::SimplificationError error = subject.meter.measure(level.mesh);
    row["trianglesReached"] = level.mesh.faces.size();
    row["meanErrorPercent"] = error.meanPercent;
    row["maxErrorPercent"] = error.maxPercent;
    row["boxExcessPercent"] = error.boxExcessPercent;
    row["uvDriftTexels"] = error.drift ? Json(error.drift->ofNinetyNine) : Json();
    row["ms"] = level.ms;
    row["trianglesWanted"] = target;
    row["stuck"] = isStuck(level.mesh.faces.size(), target);
    if (row["seams"]) row["materialsMissing"] = core::countMissingMaterials(subject.mesh, level.mesh);
    if (error.drift)
    {
        row["uvDriftMeanTexels"] = error.drift->mean;
        row["uvDriftMaxTexels"] = error.drift->largest;
        row["uvDriftVisiblePercent"] = 100.0 * error.drift->visibleShare;
    }
    if (error.smear)
    {
        row["uvSmearMeanPercent"] = error.smear->mean;
        row["uvSmearPercent"] = error.smear->ofNinetyNine;
        row["uvSmearedAreaPercent"] = 100.0 * error.smear->farShare;
    }
    if (!level.isInTime) row["timedOut"] = true;
}

foundation::Outcome dump(const core::Mesh& mesh, const std::filesystem::path& folder, const std::string& stem,
                         Json& row)
{
    row["dump"] = stem + ".obj";
    if (const auto written = writePlain(mesh, folder / (stem + ".obj")); !written) return written.error();
    if (mesh.texCoords[0].empty()) return foundation::success();
    row["dumpWithTexCoords"] = stem + ".uv.obj";
    return writeTextured(mesh, folder / (stem + ".uv.obj"));
}

std::string dumpName(const SimplifySubject& subject, const Json& row)
{
    std::ostringstream name;
    name << subject.name << '.' << row["tool"].get<std::string>() << '.' << (row["seams"] ? "seams" : "shape")
         << '.' << row["targetPercent"].get<double>();
    return name.str();
}

void printHeading(const std::string& file, const SimplifySubject& subject)
{
    std::cout << file << ": " << subject.mesh.faces.size()
              << " triangles\n  tool          keeps      % triangles      mean       max  box out    drift   "
                 "     ms\n";
}

void printRow(const Json& row)
{
    std::cout << "  " << std::left << std::setw(14) << row["tool"].get<std::string>() << std::setw(6)
              << (row["seams"] ? "seams" : "shape") << std::right << std::defaultfloat << std::setprecision(3)
              << std::setw(6) << row["targetPercent"].get<double>();
    if (row.contains("refused"))
    {
        std::cout << "  " << row["refused"].get<std::string>() << '\n';
        return;
    }
    std::cout << std::setw(9) << row["trianglesReached"].get<std::size_t>() << std::fixed
              << std::setprecision(4) << std::setw(10) << row["meanErrorPercent"].get<double>()
              << std::setw(10) << row["maxErrorPercent"].get<double>() << std::setw(10)
              << row["boxExcessPercent"].get<double>() << std::setprecision(2) << std::setw(9);
    if (row["uvDriftTexels"].is_null())
        std::cout << '-';
    else
        std::cout << row["uvDriftTexels"].get<double>();
    std::cout << std::setprecision(1) << std::setw(10) << row["ms"].get<double>()
              << (row["stuck"] ? "  stuck" : "") << (row.contains("timedOut") ? "  out of time" : "") << '\n';
}

} // namespace pmtool
