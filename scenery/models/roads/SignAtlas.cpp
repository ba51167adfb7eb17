// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/SignAtlas.h"

#include "scenery/models/roads/SignCells.h"

namespace scenery::models
{

namespace
{

SignCell cellAt(int index)
{
    constexpr float kInset = 0.02F; // of a cell: mipmaps reach over the edge
    const glm::vec2 size(1.0F / kSignColumns, 1.0F / kSignRows);
    const glm::vec2 low(static_cast<float>(index % kSignColumns) * size.x,
                        static_cast<float>(index / kSignColumns) * size.y);
    return {low + kInset * size, low + (1.0F - kInset) * size};
}

} // namespace

SignCell cellOf(SignFace face)
{
    return cellAt(static_cast<int>(face));
}

SignCell cellOfGlyph(char glyph)
{
    const auto found = kGlyphs.find(glyph);
    return found == std::string_view::npos ? cellOf(SignFace::plain)
                                           : cellAt(kFirstGlyph + static_cast<int>(found));
}

SignCell cellOfRunwayGlyph(char glyph)
{
    const auto found = kRunwayGlyphs.find(glyph);
    return found == std::string_view::npos ? cellOf(SignFace::plain)
                                           : cellAt(kFirstRunwayGlyph + static_cast<int>(found));
}

SignCell cellOfLimit(int speed, bool isLeast)
{
    if (isLeast)
        return speed % 10 == 0 && speed >= 30 && speed <= 80 ? cellAt(kFirstLeast + speed / 10 - 3)
                                                             : cellOf(SignFace::least);
    return speed % 5 == 0 && speed >= 5 && speed <= 5 * kLimits ? cellAt(kFirstLimit + speed / 5 - 1)
                                                                : cellOf(SignFace::limit);
}

} // namespace scenery::models
