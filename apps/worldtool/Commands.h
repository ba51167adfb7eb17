// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include "terminal/Report.h"

namespace worldtool
{

/// The values of the command line.
struct Request
{
    std::vector<std::filesystem::path> dems; ///< elevation rasters, one or more
    std::filesystem::path map;               ///< an OpenStreetMap extract
    std::filesystem::path world;             ///< the folder to write
};

using terminal::Report;

/// Makes a world of elevation data and a map: WORLD/roads.xodr, WORLD/world.roam, and a report of what was used. The folder is made
/// where there is none; of its files those three alone are replaced, each as a whole.
/// Errors: those of importDems(), readOsm() and buildStreets(); files that cannot be written.
foundation::Result<Report> build(const Request& request);

} // namespace worldtool
