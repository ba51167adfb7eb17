// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>

namespace foundation
{

/// Returns the folder below which a user's programs keep what they can make again: $XDG_CACHE_HOME/osgTrainer
/// or ~/.cache/osgTrainer; empty where the environment names no place. It need not be there.
/// Source: freedesktop.org, XDG Base Directory Specification.
inline std::filesystem::path cacheFolder()
{
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    if (cache && *cache) return std::filesystem::path(cache) / "osgTrainer";
    const char* const home = std::getenv("HOME");
    return home && *home ? std::filesystem::path(home) / ".cache/osgTrainer" : std::filesystem::path();
}

} // namespace foundation
