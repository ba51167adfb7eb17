// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

/// A translation unit is compiled into an object.
struct Unit
{
    std::string object; ///< below the build folder
    std::string source; ///< absolute
};

/// The units of a build folder, and the folders that any of them looks for headers in, those with the headers
/// of the tree first.
struct Units
{
    std::vector<Unit> units;
    std::vector<std::string> folders;
};

/// Reads compile_commands.json. Folders of forbidden headers, which stand in the way of OSG's in cores, are
/// left out.
/// Errors: the file is not there, is not JSON, or lists nothing.
foundation::Result<Units> readUnits(const std::filesystem::path& buildFolder);

/// Reads a list of files, one a line (as `ninja -t inputs` prints it).
foundation::Result<std::vector<std::string>> readList(const std::filesystem::path& file);
