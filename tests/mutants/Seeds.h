// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

/// Sound files to damage: written here, or found among real data.
namespace seeds
{

using Files = std::vector<std::filesystem::path>;

/// Writes a file and returns its path.
std::filesystem::path written(const std::filesystem::path& file, const std::string& text);

/// Returns a hill of 33² samples, 30 m apart, as an ESRI ASCII grid; `header` places it.
std::string hillGrid(const std::string& header = "xllcorner 0\nyllcorner 0\ncellsize 30\n");

/// Returns a grid of 12² squares over a wave, with texture coordinates, as OBJ.
std::string wavesModel();

/// Returns the files of real data below a folder with one of the extensions, up to 4 MB each; none where
/// there is no such folder.
Files realFiles(const std::filesystem::path& folder, std::initializer_list<const char*> extensions);

Files joined(Files files, const Files& more);

} // namespace seeds
