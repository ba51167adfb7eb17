// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scenery/models/paint/Canvas.h"

namespace scenery::models
{

/// Paints letters and digits as strokes of one width. `middle`: of the text; `height`: of a capital. Unknown
/// characters are gaps.
struct StrokeText
{
    std::string_view text;
    glm::vec2 middle{0.0F};
    float height = 1.0F;
    float weight = 0.16F; ///< width of a stroke, share of the height
    glm::vec4 colour{0.0F, 0.0F, 0.0F, 0.0F};
    float turnRad = 0.0F; ///< about its middle, counter-clockwise
};
void paintText(Canvas& canvas, const StrokeText& text);

} // namespace scenery::models
