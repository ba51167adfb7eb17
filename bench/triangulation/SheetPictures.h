// SPDX-License-Identifier: Apache-2.0
// Pictures for sheets of triangles.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <osg/Image>
#include <osg/Node>

#include <osgOffscreen/OffscreenViewer>

#include "measurement/view/OutlinedTriangles.h"

namespace sheet
{

/// Ends the program with a message.
[[noreturn]] void endWith(const std::string& message);

using measurement::Soup;

/// A viewer of a scene before a light sky. Ends the program where there is no context.
std::unique_ptr<osgOffscreen::OffscreenViewer> viewerOn(osg::Node* scene, int widthPx, int heightPx);

/// Writes a PNG file and adds its name to `files`. Ends the program where it cannot be written.
void write(const osg::Image& image, const std::filesystem::path& file,
           std::vector<std::filesystem::path>& files);

} // namespace sheet
