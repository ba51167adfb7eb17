// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include <osg/Image>

namespace framebench
{

/// Colour values or differences of colour values, RGB, bottom row first.
struct Picture
{
    int widthPx = 0, heightPx = 0;
    std::vector<std::int16_t> values;

    std::size_t pixels() const { return values.size() / 3; }
};

/// Returns an image whose pixels are the means of `n`² pixels, rounded to whole levels as a capture of 8 bits
/// is.
Picture boxFiltered(const osg::Image& image, int n);

Picture difference(const Picture& a, const Picture& b);

/// Writes values, or `gain` times their magnitudes, as a PNG.
foundation::Outcome writePicture(const Picture& picture, int gain, const std::filesystem::path& file);

/// Finds the silhouettes: pixels where the distance of the ground, drawn in Look::distance, jumps, and their
/// neighbours. There a level of detail moves an edge by a part of a pixel. The reciprocal of the distance of
/// a plane is nearly linear over the image; a jump is where its second difference is a twentieth of its
/// value.
std::vector<bool> silhouettes(const osg::Image& distance);

/// Returns the union of both sets, widened by one pixel.
std::vector<bool> widened(const std::vector<bool>& a, const std::vector<bool>& b, int widthPx);

} // namespace framebench
