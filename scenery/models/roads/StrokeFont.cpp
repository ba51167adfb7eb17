// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/StrokeFont.h"

#include <array>
#include <cmath>

namespace scenery::models
{

namespace
{

/// The lines of a glyph on a grid of 5 columns (a to e) and 7 rows (0 below to 6), for example "a0a6" is the
/// left edge; lines follow each other from point to point, a space lifts the pen.
struct Glyph
{
    char name;
    std::string_view lines;
};

constexpr std::array kStrokes{Glyph{'A', "a0a4c6e4e0 a2e2"},
                              Glyph{'B', "a0a6d6e5e4d3a3 d3e2e1d0a0"},
                              Glyph{'C', "e5d6b6a5a1b0d0e1"},
                              Glyph{'D', "a0a6c6e4e2c0a0"},
                              Glyph{'E', "e0a0a6e6 a3d3"},
                              Glyph{'F', "a0a6e6 a3d3"},
                              Glyph{'G', "e5d6b6a5a1b0d0e1e3c3"},
                              Glyph{'H', "a0a6 e0e6 a3e3"},
                              Glyph{'I', "c0c6"},
                              Glyph{'J', "e6e1d0b0a1"},
                              Glyph{'K', "a0a6 e6a3e0"},
                              Glyph{'L', "a6a0e0"},
                              Glyph{'M', "a0a6c3e6e0"},
                              Glyph{'N', "a0a6e0e6"},
                              Glyph{'O', "b0a1a5b6d6e5e1d0b0"},
                              Glyph{'P', "a0a6d6e5e4d3a3"},
                              Glyph{'Q', "b0a1a5b6d6e5e1d0b0 c2e0"},
                              Glyph{'R', "a0a6d6e5e4d3a3 c3e0"},
                              Glyph{'S', "e5d6b6a5a4b3d3e2e1d0b0a1"},
                              Glyph{'T', "c0c6 a6e6"},
                              Glyph{'U', "a6a1b0d0e1e6"},
                              Glyph{'V', "a6c0e6"},
                              Glyph{'W', "a6b0c4d0e6"},
                              Glyph{'X', "a0e6 a6e0"},
                              Glyph{'Y', "a6c3e6 c3c0"},
                              Glyph{'Z', "a6e6a0e0"},
                              Glyph{'0', "b0a1a5b6d6e5e1d0b0"},
                              Glyph{'1', "a4c6c0"},
                              Glyph{'2', "a5b6d6e5e4a0e0"},
                              Glyph{'3', "a6e6c4d4e3e1d0b0a1"},
                              Glyph{'4', "d0d6a2e2"},
                              Glyph{'5', "e6a6a3d4e3e1d0b0a1"},
                              Glyph{'6', "d6b5a3a1b0d0e1e2d3b3a2"},
                              Glyph{'7', "a6e6b0"},
                              Glyph{'8', "b3a4a5b6d6e5e4d3b3a2a1b0d0e1e2d3"},
                              Glyph{'9', "b0d1e3e5d6b6a5a4b3d3e4"},
                              Glyph{'-', "b3d3"},
                              Glyph{'.', "c0c0"},
                              Glyph{'/', "a0e6"},
                              Glyph{':', "c1c1 c4c4"},
                              Glyph{',', "c1b0"},
                              Glyph{'(', "d6c5c1d0"},
                              Glyph{')', "b6c5c1b0"},
                              Glyph{'\xC4', "a0a3c5e3e0 a1e1 b6b6 d6d6"},
                              Glyph{'\xC5', "a0a3c4e3e0 a1e1 c6c6"},
                              Glyph{'\xC9', "e0a0a4e4 a2d2 c5d6"},
                              Glyph{'\xD6', "b0a1a3b4d4e3e1d0b0 b6b6 d6d6"},
                              Glyph{'\xDC', "a4a1b0d0e1e4 b6b6 d6d6"}};

constexpr float kAspect = 0.56F;  ///< width of a glyph, share of its height
constexpr float kAdvance = 0.86F; ///< from a glyph to the next

void paintGlyph(Canvas& canvas, const StrokeText& text, std::string_view lines, const glm::vec2& low)
{
    const auto pointAt = [&](std::size_t i)
    {
        const glm::vec2 out = low - text.middle +
                              text.height * glm::vec2(kAspect * static_cast<float>(lines[i] - 'a') / 4.0F,
                                                      static_cast<float>(lines[i + 1] - '0') / 6.0F);
        const float c = std::cos(text.turnRad), s = std::sin(text.turnRad);
        return text.middle + glm::vec2(c * out.x - s * out.y, s * out.x + c * out.y);
    };
    const float width = text.weight * text.height;
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2)
    {
        if (lines[i] == ' ') ++i;
        const glm::vec2 from = pointAt(i);
        canvas.disc(from, 0.5F * width, text.colour);
        if (i + 3 < lines.size() && lines[i + 2] != ' ')
            canvas.stroke(from, pointAt(i + 2), glm::vec2(width), text.colour);
    }
}

} // namespace

void paintText(Canvas& canvas, const StrokeText& text)
{
    const float advance = kAdvance * text.height;
    const float whole = advance * static_cast<float>(text.text.size() - 1) + kAspect * text.height;
    glm::vec2 low = text.middle - 0.5F * glm::vec2(whole, text.height);
    for (const char c : text.text)
    {
        for (const Glyph& glyph : kStrokes)
            if (glyph.name == c) paintGlyph(canvas, text, glyph.lines, low);
        low.x += advance;
    }
}

} // namespace scenery::models
