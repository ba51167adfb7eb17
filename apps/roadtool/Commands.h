// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "terminal/Report.h"

namespace roadtool
{

/// The values of the command line.
struct Request
{
    std::vector<std::string> files; ///< .xodr

    // Of validate alone.
    std::size_t mostLines = 20; ///< of each kind and file; 0: all

    // Of draw alone.
    std::filesystem::path svgFile, pngFile; ///< empty: none
    int pixels = 1600;                      ///< of the longer side
};

using terminal::Report;

/// Counts, lengths, bounds and what is not supported, of each file.
foundation::Result<Report> info(const Request& request);

/// Mistakes, gaps, kinks, overlaps of each file. A file that cannot be used makes the report unsound.
foundation::Result<Report> validate(const Request& request);

/// The first file seen from above, as SVG, PNG or both.
foundation::Result<Report> draw(const Request& request);

} // namespace roadtool
