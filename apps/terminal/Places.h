// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

namespace terminal
{

/// A folder that a command writes, and a file that will be in it.
struct WrittenFolder
{
    std::filesystem::path folder, file;
};

/// What a command line names, by what the command does with it. Empty paths stand for none.
struct Places
{
    std::vector<std::filesystem::path> written; ///< files
    std::vector<WrittenFolder> folders;         ///< made where they are missing
    std::vector<std::filesystem::path> read;    ///< files, not those that GDAL names (/vsi…)
};

/// Tells at once, before any work, whether all of them can be used: first what is written, then what is read.
/// Leaves no trace; of files that are read one byte is read. Errors: of the first that cannot be used, as
/// checkWritable(), checkFolderWritable(), checkReadable().
foundation::Outcome checkPlaces(const Places& places);

} // namespace terminal
