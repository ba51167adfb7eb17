// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/PlainBytes.h>
#include <glm/vec2.hpp>

namespace osgTerrainROAM::core
{

using Paths = std::vector<std::vector<glm::dvec2>>;

/// Appends the number of paths, and each.
inline void appendPaths(std::string& bytes, const Paths& paths)
{
    foundation::appendValue(bytes, static_cast<std::uint64_t>(paths.size()));
    for (const auto& path : paths)
        foundation::appendValues(bytes, path);
}

/// False: appendPaths() did not write them.
inline bool takePaths(foundation::ValueTaker& taker, Paths& paths)
{
    std::uint64_t count = 0;
    if (!taker.takeCount(count, sizeof(std::uint64_t))) return false;
    paths.resize(static_cast<std::size_t>(count));
    for (auto& path : paths)
        if (!taker.take(path)) return false;
    return true;
}

} // namespace osgTerrainROAM::core
