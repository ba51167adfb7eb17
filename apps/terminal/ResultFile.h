// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include <viewlod/Result.h>

namespace terminal
{

/// Writes text to a temporary name beside `file`, then renames it: a reader never sees half a file. A link stays one:
/// what it points at is written. A device or pipe (/dev/stdout) is written to as it is.
viewlod::Outcome writeFile(const std::filesystem::path& file, const std::string& text);

/// Whether writeFile could work, to be asked before hours of work; leaves nothing behind. An empty path is one that
/// nobody asked for: well.
viewlod::Outcome checkWritable(const std::filesystem::path& file);

} // namespace terminal
