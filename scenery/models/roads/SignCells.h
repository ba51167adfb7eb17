// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "scenery/models/roads/SignAtlas.h"

namespace scenery::models
{

/// The order of the cells of the atlas: faces, speed limits, least speeds, glyphs.
inline constexpr std::string_view kGlyphs = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-.";
constexpr int kFirstLimit = static_cast<int>(SignFace::count);
constexpr int kLimits = 26; ///< 5, 10 … 130
constexpr int kFirstLeast = kFirstLimit + kLimits;
constexpr int kLeasts = 6; ///< 30, 40 … 80
constexpr int kFirstGlyph = kFirstLeast + kLeasts;
static_assert(kFirstGlyph + static_cast<int>(kGlyphs.size()) <= kSignColumns * kSignRows);

} // namespace scenery::models
