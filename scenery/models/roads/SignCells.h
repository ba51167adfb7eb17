// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "scenery/models/roads/SignAtlas.h"

namespace scenery::models
{

/// The order of the cells of the atlas: faces, speed limits, least speeds, glyphs, those of runways.
inline constexpr std::string_view kGlyphs = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-./:,()\xC4\xC5\xC9\xD6\xDC";
constexpr int kFirstLimit = static_cast<int>(SignFace::count);
constexpr int kLimits = 28; ///< 5, 10 … 140
constexpr int kFirstLeast = kFirstLimit + kLimits;
constexpr int kLeasts = 6; ///< 30, 40 … 80
constexpr int kFirstGlyph = kFirstLeast + kLeasts;
constexpr int kFirstRunwayGlyph = kFirstGlyph + static_cast<int>(kGlyphs.size());
inline constexpr std::string_view kRunwayGlyphs = "0123456789CLR"; ///< white on red
static_assert(kFirstRunwayGlyph + static_cast<int>(kRunwayGlyphs.size()) <= kSignColumns * kSignRows);

} // namespace scenery::models
