// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// The alpha below which foliage is not drawn.
constexpr int kAlphaThreshold = 110;

/// Returns the share of the pixels of an image whose alpha is above the threshold.
double coverageOf(const Picture& picture);

/// Makes the mipmaps of an image down to one pixel; each pixel is the mean of four. With `keepCoverage` the
/// alpha of each level is scaled so that the same share of pixels passes the threshold as in the first level;
/// plain means change that share, and trees would get denser and then vanish with distance. Colours are then
/// weighted by alpha, so that transparent pixels do not bleed in.
/// Source: Castaño, *Computing Alpha Mipmaps*, 2010; the scale is found by bisection.
std::vector<Picture> mipChain(const Picture& picture, bool keepCoverage);

} // namespace scenery::models
