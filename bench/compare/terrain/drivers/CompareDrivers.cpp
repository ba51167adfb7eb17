// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "compare/terrain/drivers/BenchDump.h"
#include "compare/terrain/drivers/BenchParts.h"
#include "compare/terrain/drivers/BenchRun.h"
#include "compare/terrain/drivers/BenchSquare.h"
#include "compare/terrain/drivers/DriversRequest.h"
#include "terminal/Terminal.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

void printRow(const nlohmann::ordered_json& row)
{
    const auto number = [&](const char* key) { return row[key].get<double>(); };
    std::cout << std::left << std::setw(8) << row["driver"].get<std::string>() << std::setw(8)
              << row["path"].get<std::string>() << std::right << std::fixed << std::setprecision(1)
              << std::setw(6) << number("tolerancePx") << " px" << std::setw(10) << number("triangles")
              << " triangles" << std::setw(10) << number("adaptUsP50") << " us" << std::setw(10)
              << number("adaptUsP99") << " us p99" << std::setw(9) << number("changesPerFrame") << " changes"
              << std::setprecision(2) << std::setw(7) << number("maxErrorPx") << " px off"
              << std::endl; // at once, into a file too
}

bool isWanted(const DriversRequest& request, const BenchRun& run)
{
    const auto& names = request.drivers;
    return names.empty() || std::find(names.begin(), names.end(), run.driverName()) != names.end();
}

foundation::Outcome benchTile(const DriversRequest& request, const std::string& file,
                              const SplitBounds& bounds, nlohmann::ordered_json& json)
{
    const std::optional<Driver> drivers[] = {Driver::wheel, Driver::walk, Driver::queue, std::nullopt};
    for (const double tolerancePx : request.tolerancesPx)
        for (const measurement::Path path : measurement::kPaths)
            for (const auto& driver : drivers)
            {
                BenchRun run{std::filesystem::path(file).filename().string(),
                             bounds,
                             driver,
                             request.leavesNearby ? LeafPlacement::nearby : LeafPlacement::inOrder,
                             path,
                             tolerancePx,
                             request.centrePixels,
                             request.frames,
                             request.framesBetweenChecks};
                if (!isWanted(request, run)) continue;
                auto row =
                    measure(run, request.dumpFolder.empty() ? FrameSink() : dumpTo(request.dumpFolder, run));
                if (!row) return row.error();
                printRow(*row);
                json["runs"].push_back(std::move(*row));
            }
    return foundation::success();
}

/// Measures the whole raster on the round Earth; nothing for a raster without georeference.
nlohmann::ordered_json queriesOnTheEarth(const HeightField& field)
{
    if (!field.net) return nullptr;
    return measureQueries(std::make_shared<const RoamTile>(PlacedTile(field, Placement::curved)));
}

} // namespace

foundation::Result<terminal::Report> compareDrivers(const DriversRequest& request)
{
    terminal::Report report;
    if (!request.dumpFolder.empty())
    {
        std::error_code failed;
        std::filesystem::create_directories(request.dumpFolder, failed);
        if (failed)
            return foundation::Error{request.dumpFolder.string(), failed.message(),
                                     "name a folder that can be made"};
    }
    for (const std::string& file : request.files)
    {
        const auto field = importDem(file, request.import);
        if (!field) return field.error();
        auto square = squareOf(*field, {request.crop, request.cellM}, file);
        if (!square) return square.error();
        const auto tile = std::make_shared<const RoamTile>(PlacedTile(std::move(*square), Placement::planar));
        std::cout << file << ": " << tile->tile.grid().side() << " x " << tile->tile.grid().side()
                  << " samples of " << tile->tile.field().spacingEastM << " m" << std::endl;
        const SplitBounds bounds(tile, request.patchExponent);
        if (const auto done = benchTile(request, file, bounds, report.json); !done) return done.error();
        if (report.json.contains("enhMerge"))
            continue; // the first terrain serves for what hardly depends on it
        report.json["enhMerge"] = measureMerges(tile);
        report.json["bytesPerSample"] = static_cast<double>(tile->tile.samples().table().memoryBytes()) /
                                        static_cast<double>(tile->tile.samples().table().size());
        report.json["bytesPerActiveTriangle"] = report.json["runs"][0]["bytesPerActiveTriangle"];
        report.json["slices"] = measureSlices(tile);
        report.json["pops"] = measurePops(tile);
        report.json["queriesPerSecond"] = measureQueries(tile);
        report.json["queriesPerSecondCurved"] = queriesOnTheEarth(*field);
    }
    for (const char* key : {"enhMerge", "bytesPerSample", "bytesPerActiveTriangle", "slices", "pops",
                            "queriesPerSecond", "queriesPerSecondCurved"})
        std::cout << key << ": " << report.json[key].dump() << '\n';
    return report;
}

} // namespace terraintool
