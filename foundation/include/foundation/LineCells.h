// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace foundation
{

/// Returns the cells of a line of text, parted by blanks and tabs; what stands behind a # counts for nothing.
inline std::vector<std::string_view> lineCells(std::string_view line)
{
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> cells;
    for (std::size_t at = 0;;)
    {
        at = line.find_first_not_of(" \t\r", at);
        if (at == std::string_view::npos) return cells;
        const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        cells.push_back(line.substr(at, end - at));
        at = end;
    }
}

} // namespace foundation
