// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <osgOffscreen/OffscreenViewer>

namespace objectbench
{

/// What the command line asks for.
struct Request
{
    std::vector<std::string> files;
    std::vector<int> lights{32, 96};
    int levels = 10, repeats = 15;
    double movingPercent = 0.0; ///< of the steps, by which a level changes from frame to frame; 0: it rests
    osgOffscreen::OffscreenSettings picture{.widthPx = 640, .heightPx = 480};
    /// static levels as triangles and as strips, instead of orders of progressive meshes
    bool asStrips = false;
    std::filesystem::path jsonFile, plotFile, markdownFile;
};

} // namespace objectbench
