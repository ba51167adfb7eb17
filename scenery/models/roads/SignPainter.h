// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "scenery/models/paint/Canvas.h"

namespace scenery::models
{

/// Paints one sign in a frame of its own: (0, 0) is its middle, ±1 its edges.
class SignPainter
{
public:
    /// Alpha 0: no tint. Colours: the display values of retroreflective sheeting in daylight, near EN
    /// 12899-1:2007, table 2.
    static constexpr glm::vec4 kRed{0.76F, 0.07F, 0.08F, 0.0F};
    static constexpr glm::vec4 kBlue{0.02F, 0.27F, 0.60F, 0.0F};
    static constexpr glm::vec4 kWhite{0.95F, 0.95F, 0.94F, 0.0F};
    static constexpr glm::vec4 kYellow{0.97F, 0.80F, 0.05F, 0.0F};
    static constexpr glm::vec4 kBlack{0.06F, 0.06F, 0.07F, 0.0F};
    static constexpr glm::vec4 kGrey{0.55F, 0.56F, 0.57F, 0.0F};

    explicit SignPainter(Canvas& canvas) : _canvas(canvas) {}

    Canvas& canvas() { return _canvas; }
    void ground(const glm::vec4& colour); ///< fills the whole cell
    void ring(const glm::vec4& rim, const glm::vec4& inside);
    void triangle(bool pointsUp);
    void fill(std::initializer_list<glm::vec2> corners, const glm::vec4& colour);
    void line(std::initializer_list<glm::vec2> points, float width, const glm::vec4& colour);
    void arrow(const glm::vec2& from, const glm::vec2& to, const glm::vec4& colour);
    void disc(const glm::vec2& middle, float radius, const glm::vec4& colour)
    {
        _canvas.disc(middle, radius, colour);
    }
    void person(const glm::vec2& foot, float height, const glm::vec4& colour);
    void car(const glm::vec2& middle, float width, const glm::vec4& colour);
    void text(std::string_view words, float height, const glm::vec4& colour);

private:
    Canvas& _canvas;
};

} // namespace scenery::models
