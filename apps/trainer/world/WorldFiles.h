// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <foundation/Result.h>

namespace trainer
{

/// Whether a world is shown where the command line names none.
struct WorldChoice
{
    bool isLeftOut = false;       ///< the elevation alone, or level ground
    std::filesystem::path folder; ///< of a world that is made up; empty: one in the cache of the user
};

/// Returns world.roam of the default world, which lies in ../share/osgtrainer/data/world (installed) or
/// ../data/world (built) from the folder of the program. Where it is not there it is made of
/// default_terrain.tif beside it, which is told: in ../data/world, or in the user's cache where the program
/// is installed. Errors: there is no such terrain; those of `worldtool build`.
foundation::Result<std::filesystem::path> defaultWorld();

/// Returns world.roam of the world that `worldtool build` makes up over an elevation raster, once for each
/// raster and program; what is done is told. Absent, after a line that says why, where none can be made; that
/// of a .roam file, an OpenDRIVE network and a file that is not there.
/// Frame: that of the raster, so the two show the same ground.
std::optional<std::filesystem::path> worldOver(const std::filesystem::path& dem,
                                               const std::filesystem::path& folder);

} // namespace trainer
