// SPDX-License-Identifier: Apache-2.0
#include "pmtool/PmInfo.h"

#include <filesystem>
#include <fstream>

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

} // namespace

bool isPmFile(const std::string& file)
{
    return std::filesystem::path(file).extension() == ".pm";
}

foundation::Result<Json> describePm(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return foundation::Error{file, "cannot be opened", "check its path and permissions"};
    PmReader reader(stream, file);
    Json stops = Json::array();
    while (true)
    {
        const auto more = reader.readMore();
        if (!more) return more.error();
        if (!*more) break;
        const auto soFar = reader.mesh();
        if (!soFar) return soFar.error();
        stops.push_back(soFar->mesh.positions.size());
    }
    const auto mesh = reader.mesh();
    if (!mesh) return mesh.error();
    Json row{{"model", file},
             {"positions", mesh->mesh.positions.size()},
             {"vertices", mesh->mesh.wedgeCount()},
             {"steps", mesh->stepCount},
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
    return row;
}

} // namespace pmtool
