// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Below this alpha foliage is not drawn.
constexpr int kAlphaThreshold = 110;

/// Share of a picture's pixels whose alpha is above the threshold.
double coverageOf(const Picture& picture);

/// A picture and its halves down to one pixel, each the mean of four. With `keepCoverage` the alpha of every level is scaled so
/// that as large a share as in the first passes the threshold: plain means change it, crowns get denser with distance and at last vanish.
/// Colours are weighted by alpha then, so that what is cut out does not bleed in.
/// Source: Castaño, "Computing alpha mipmaps" (2010); the scale by halving an interval.
std::vector<Picture> mipChain(const Picture& picture, bool keepCoverage);

} // namespace scenery::models
