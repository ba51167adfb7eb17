// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <osgOffscreen/OffscreenViewer>

namespace fieldbench
{

/// The values of the command line.
struct Request
{
    std::uint32_t count = 10000;
    double spacingM = 18.0;
    std::vector<double> trianglesPx{16.0}, lodTrianglesPx{16.0}; ///< each is flown
    int frames = 24, compared = 2;
    osgOffscreen::OffscreenSettings picture{.widthPx = 960, .heightPx = 540};
    std::vector<std::string> contestants{"ours", "lod", "full"};
    std::filesystem::path jsonFile, pictures;

    bool has(const std::string& name) const
    {
        return std::find(contestants.begin(), contestants.end(), name) != contestants.end();
    }
};

} // namespace fieldbench
