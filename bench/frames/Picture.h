// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include <osg/Image>

namespace framebench
{

/// Colour values or differences of them, RGB, bottom row first.
struct Picture
{
    int widthPx = 0, heightPx = 0;
    std::vector<std::int16_t> values;

    std::size_t pixels() const { return values.size() / 3; }
};

/// Every pixel the mean of `n`² pixels, rounded to whole levels as a capture of 8 bits is.
Picture boxFiltered(const osg::Image& image, int n);

Picture difference(const Picture& a, const Picture& b);

/// Values, or `gain` times their magnitudes, as a PNG.
foundation::Outcome writePicture(const Picture& picture, int gain, const std::filesystem::path& file);

/// Pixels at which the ground's distance, drawn in Look::distance, jumps: where something stands before something
/// farther away or before the sky, and their neighbours. There a level of detail moves the edge by a part of a pixel.
/// The reciprocal of a plane's distance is (nearly) linear over the picture: a jump is where the second difference of it is
/// a twentieth of itself.
std::vector<bool> silhouettes(const osg::Image& distance);

/// One or the other, and the pixels beside either.
std::vector<bool> widened(const std::vector<bool>& a, const std::vector<bool>& b, int widthPx);

} // namespace framebench
