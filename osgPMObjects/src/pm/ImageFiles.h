// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <osg/Image>
#include <osg/ref_ptr>

#include <osgPMObjects/core/progressive/PmFile.h>

namespace osgPMObjects
{

/// The user value of an osg::Image that holds the file from which it was decoded, as a std::string of bytes.
constexpr const char* kImageFileValue = "osgPMObjects.imageFile";

/// Returns an image as the bytes of an image file: the smallest of the file that it came from
/// (kImageFileValue, or its file name, also within `folder`), if that still shows the same; a PNG file;
/// OpenSceneGraph's binary format, compressed. Nothing is lost besides what the file it came from has lost.
/// Without bytes: OpenSceneGraph can write none of them.
core::PmImage asImageFile(const osg::Image& image, const std::filesystem::path& folder);

/// Decodes the bytes of an image file with OpenSceneGraph's plugins. Returns nothing where that fails.
osg::ref_ptr<osg::Image> decoded(const core::PmImage& file);

} // namespace osgPMObjects
