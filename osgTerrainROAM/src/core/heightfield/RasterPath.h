// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

namespace osgTerrainROAM::core
{

/// Lists the names under which GDAL may open a file: the file, the content of a .gz, or each member of a .zip
/// (elevation formats first, otherwise by name).
/// Errors: missing, a folder, unreadable, an archive without members.
foundation::Result<std::vector<std::string>> rasterPaths(const std::filesystem::path& file);

} // namespace osgTerrainROAM::core
