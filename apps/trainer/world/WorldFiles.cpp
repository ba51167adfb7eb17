// SPDX-License-Identifier: Apache-2.0
#include "WorldFiles.h"

#include <iostream>
#include <string>
#include <vector>

#include <foundation/CacheFolder.h>
#include <foundation/DataFile.h>
#include <foundation/Fnv1a.h>

#include "RunProgram.h"

namespace trainer
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* kLeaveOut = "name a WORLD, or give --no-world";

/// A name that differs for rasters of the same name in different folders.
std::string folderName(const fs::path& dem)
{
    foundation::Fnv1a sum;
    sum.add(dem.string());
    return dem.stem().string() + '-' + sum.text();
}

/// Makes a world, or finds it made. One program at a time does that in a folder.
foundation::Result<fs::path> madeWorld(const fs::path& dem, const fs::path& folder)
{
    const fs::path tool = foundation::programFolder() / "worldtool";
    std::error_code failed;
    if (!fs::exists(tool, failed))
        return foundation::Error{tool.string(), "is not there, so no world can be made up", kLeaveOut};
    fs::create_directories(folder, failed);
    if (failed)
        return foundation::Error{folder.string(), "cannot be made: " + failed.message(),
                                 "give --world-folder FOLDER that can be written"};
    const fs::path world = folder / "world.roam";
    if (!fs::exists(world, failed))
        std::cerr << "trainer: makes up a world over " << dem.string() << " in " << folder.string()
                  << ", once; --no-world leaves it out\n";
    const auto ran = runProgram(
        {tool.string(), "build", dem.string(), "--seed", "1", "--output", folder.string()}, folder / "lock");
    if (!ran) return ran.error();
    if (*ran != 0 || !fs::exists(world, failed))
        return foundation::Error{dem.string(), "no world is made up over it", kLeaveOut};
    return world;
}

/// The same in the cache of the user.
foundation::Result<fs::path> madeInCache(const fs::path& dem)
{
    const fs::path cache = foundation::cacheFolder();
    if (cache.empty())
        return foundation::Error{"HOME", "is not set, so there is no cache for a world", kLeaveOut};
    return madeWorld(dem, fs::absolute(cache / "worlds" / folderName(dem)));
}

} // namespace

foundation::Result<fs::path> defaultWorld()
{
    const fs::path above = foundation::programFolder().parent_path(),
                   installed = above / "share/osgtrainer/data", built = above / "data";
    std::error_code failed;
    for (const fs::path& data : {installed, built})
        if (const fs::path world = data / "world/world.roam"; fs::exists(world, failed)) return world;
    if (const fs::path dem = built / "default_terrain.tif"; fs::exists(dem, failed))
        return madeWorld(dem, built / "world");
    // What is installed may be read alone.
    if (const fs::path dem = installed / "default_terrain.tif"; fs::exists(dem, failed))
        return madeInCache(dem);
    return foundation::Error{(built / "world/world.roam").string(), "the default world is not there",
                             "build the target default_world, or " + std::string(kLeaveOut)};
}

std::optional<fs::path> worldOver(const fs::path& dem, const fs::path& folder)
{
    std::error_code failed;
    const std::string suffix = dem.extension().string();
    if (suffix == ".roam" || suffix == ".xodr" || suffix == ".mt" || !fs::is_regular_file(dem, failed))
        return std::nullopt;
    const fs::path place = fs::canonical(dem, failed);
    const auto made = folder.empty() ? madeInCache(place) : madeWorld(place, fs::absolute(folder));
    if (made) return *made;
    std::cerr << "note: " << made.error().message() << "; the elevation is shown alone\n";
    return std::nullopt;
}

} // namespace trainer
