// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "roadtool/TopView.h"

namespace roadtool
{

/// Returns a top view as SVG: one unit is a metre, north is up, `pixels` for the longer side where no size is
/// asked for.
std::string svgText(const TopView& view, int pixels);

/// An image of 8-bit RGB pixels, row by row from the north-west.
struct RgbImage
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Paints a top view with antialiased edges. `pixels`: of the longer side.
/// Source: the area coverage of scan lines, in four lines for each row of pixels; polygons are filled by the
/// even-odd rule (Foley et al., *Computer Graphics: Principles and Practice*, 1990, 3.6).
RgbImage paintedImage(const TopView& view, int pixels);

/// Writes a PNG file, whole or not at all. Errors: as foundation::WholeFile.
foundation::Outcome writePng(const RgbImage& image, const std::filesystem::path& file);

} // namespace roadtool
