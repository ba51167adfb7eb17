// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>

#include <foundation/ReadableFile.h>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/heightfield/DemCheck.h>

#include "terraintool/Commands.h"
#include "terraintool/mt/ExtractMt.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// Counts the raster's samples that are not holes.
std::size_t samplesThere(const PlacedTile& tile)
{
    const HeightField& field = tile.field();
    std::size_t count = 0;
    for (int row = 0; row < field.rows; ++row)
        count += static_cast<std::size_t>(tile.samples().mask().countIn(row, 0, field.columns - 1));
    return count;
}

nlohmann::ordered_json describe(const std::string& file, const PlacedTile& tile)
{
    const HeightField& field = tile.field();
    const SampleTable& samples = tile.samples().table();
    float lowestM = samples.heightM(0), highestM = lowestM;
    for (std::size_t i = 1; i < samples.size(); ++i)
    {
        lowestM = std::min(lowestM, samples.heightM(i));
        highestM = std::max(highestM, samples.heightM(i));
    }
    nlohmann::ordered_json row;
    row["file"] = file;
    row["columns"] = field.columns;
    row["rows"] = field.rows;
    row["samples"] = samples.size();
    row["tileSide"] = tile.grid().side();
    row["spacingEastM"] = field.spacingEastM;
    row["spacingNorthM"] = field.spacingNorthM;
    row["lowestM"] = lowestM;
    row["highestM"] = highestM;
    row["heightQuantumM"] = samples.heightQuantumM();
    row["voids"] = field.voids.count;
    row["voidShare"] = field.voids.share;
    if (field.voids.count > 0) row["voidFill"] = field.voids.method;
    row["rasters"] = field.mosaic.rasters;
    if (field.mosaic.rasters > 1)
    {
        row["seamStepM"] = field.mosaic.largestStepM;
        row["bentSamples"] = field.mosaic.bentSamples;
    }
    for (const SampleSheet& sheet : tile.samples().sheets())
        row["parts"].push_back(
            {{"samples", sheet.table().size()},
             {"spacingNorthM", field.spacingNorthM * sheet.step() / tile.grid().cellSide()}});
    if (!field.notes.empty()) row["notes"] = field.notes;
    row["missing"] = samples.size() - samplesThere(tile);
    row["georeferenced"] = field.net.has_value();
    if (field.net)
    {
        row["originLatitudeDeg"] = tile.frame().origin().latitudeDeg;
        row["originLongitudeDeg"] = tile.frame().origin().longitudeDeg;
        row["geoidM"] = field.net->nodes.front().geoidM;
    }
    return row;
}

void printInfo(const nlohmann::ordered_json& row)
{
    std::cout << row["file"].get<std::string>() << '\n';
    for (const auto& [key, value] : row.items())
        if (key != "file")
            std::cout << "  " << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump())
                      << '\n';
}

} // namespace

foundation::Outcome checkHeads(const Request& request)
{
    for (const std::filesystem::path file : request.files)
    {
        const std::string suffix = file.extension().string();
        if (suffix == ".mt") continue; // its faults are findings
        const auto description = describeTerrain(file, request.import);
        const auto sound = suffix == ".xosc" ? foundation::checkReadable(file)
                           : description     ? checkDems(description->dems, description->import)
                                             : description.error();
        if (!sound) return sound;
    }
    return foundation::success();
}

foundation::Result<Report> info(const Request& request)
{
    if (const auto sound = checkHeads(request); !sound) return sound.error();
    Report report;
    for (const std::string& file : request.files)
    {
        if (std::filesystem::path(file).extension() == ".mt")
        {
            const auto opened = osgMultiTriangulation::core::MtFile::open(file);
            if (!opened) return opened.error();
            report.json["files"].push_back(describeMt(*opened));
            printInfo(report.json["files"].back());
            continue;
        }
        const auto description = describeTerrain(file, request.import);
        if (!description) return description.error();
        const auto tile = loadTile(*description);
        if (!tile) return tile.error();
        report.json["files"].push_back(describe(file, *tile));
        printInfo(report.json["files"].back());
    }
    return report;
}

} // namespace terraintool
