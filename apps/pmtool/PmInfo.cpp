// SPDX-License-Identifier: Apache-2.0
#include "pmtool/PmInfo.h"

#include <filesystem>
#include <fstream>

#include <foundation/ReadableFile.h>

#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace pmtool
{

namespace
{

using namespace osgPMObjects::core;
using Json = nlohmann::ordered_json;

/// Returns triangles and errors of the level that has so many per cent of the positions.
Json levelsOf(const ProgressiveMesh& mesh)
{
    Json levels = Json::array();
    ProgressiveLevel level(mesh);
    for (const std::uint32_t percent : {100u, 50u, 25u, 10u, 5u, 1u})
    {
        const auto left = static_cast<std::uint32_t>(mesh.mesh.positions.size() * percent / 100);
        const auto steps =
            std::min(mesh.stepCount, static_cast<std::uint32_t>(mesh.mesh.positions.size()) - left);
        level.moveTo(steps);
        const LevelError error = errorAfter(mesh, steps);
        levels.push_back({{"positions", mesh.mesh.positions.size() - steps},
                          {"triangles", level.faceCount()},
                          {"distance", error.distance},
                          {"texCoord", error.texCoord}});
    }
    return levels;
}

/// Returns triangles and measured errors of the levels of the ladder.
Json ladderOf(const ProgressiveMesh& mesh)
{
    Json ladder = Json::array();
    ProgressiveLevel level(mesh);
    for (const MeasuredLevel& measured : mesh.ladder)
    {
        level.moveTo(measured.steps);
        ladder.push_back({{"triangles", level.faceCount()},
                          {"errorMax", measured.error.maximum},
                          {"errorRms", measured.error.rootMeanSquare}});
    }
    return ladder;
}

/// Returns the bytes of each image, by its format.
Json imagesOf(const std::vector<PmImage>& images)
{
    Json table = Json::array();
    for (const PmImage& image : images)
        table.push_back({{"name", image.name}, {"format", image.format}, {"bytes", image.bytes.size()}});
    return table;
}

} // namespace

bool isPmFile(const std::string& file)
{
    return std::filesystem::path(file).extension() == ".pm";
}

foundation::Result<Json> describePm(const std::string& file)
{
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    std::ifstream stream(file, std::ios::binary);
    PmReader reader(stream, file);
    Json stops = Json::array();
    auto more = reader.readMore();
    if (!more) return more.error();
    for (; more && *more; more = reader.readMore())
        stops.push_back(reader.positions());
    if (!more && !reader.isCutOff()) return more.error();
    const auto mesh = reader.mesh();
    if (!mesh) return mesh.error();
    Json row{{"model", file},
             {"positions", mesh->mesh.positions.size()},
             {"vertices", mesh->mesh.wedgeCount()},
             {"steps", mesh->stepCount},
             {"missingSteps", reader.totalSteps() - mesh->stepCount},
             {"images", imagesOf(reader.images())},
             {"blocks", mesh->blocks.size()},
             {"recordBytes", mesh->records.size()},
             {"overheadBytesPerVertex",
              static_cast<double>(mesh->overheadBytes()) / static_cast<double>(mesh->mesh.wedgeCount())},
             {"positionsAfterSections", std::move(stops)},
             {"levels", levelsOf(*mesh)},
             {"ladder", ladderOf(*mesh)},
             {"materials", Json::array()}};
    for (const FaceGroup& group : mesh->groups)
        row["materials"].push_back(mesh->mesh.materials[group.material].name);
    if (!more) row["notes"] = Json::array({"the file is cut off: " + more.error().message()});
    return row;
}

} // namespace pmtool
