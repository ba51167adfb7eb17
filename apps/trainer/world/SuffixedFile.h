// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace trainer
{

/// Returns a file's name with a suffix before its extension; an empty one stays empty.
inline std::filesystem::path withSuffix(const std::filesystem::path& file, const std::string& suffix)
{
    if (file.empty()) return file;
    return file.parent_path() / (file.stem().string() + suffix + file.extension().string());
}

} // namespace trainer
