// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// An image being painted: red, green, blue, alpha from 0 to 1, y upwards. Painting replaces all four
/// channels, so the edge of a cut-out leaf has the colour of the leaf instead of a dark rim.
/// Units: positions and lengths in pixels times `scale` about `origin`, so that parts can be painted in
/// metres.
class Canvas
{
public:
    Canvas(int widthPx, int heightPx, const glm::vec4& colour);

    /// Sets the unit of what follows to `pixelsPerUnit`, with (0, 0) at `originPx`.
    void setFrame(const glm::vec2& originPx, const glm::vec2& pixelsPerUnit);

    int widthPx() const { return _widthPx; }
    int heightPx() const { return _heightPx; }
    glm::vec4& pixel(int x, int y) { return _pixels[static_cast<std::size_t>(y) * _widthPx + x]; }

    /// Fills a simple polygon (even-odd), its edges smoothed with 4 × 4 samples a pixel.
    void polygon(std::span<const glm::vec2> corners, const glm::vec4& colour);
    void rectangle(const glm::vec2& low, const glm::vec2& high, const glm::vec4& colour);
    /// Fills a rectangle with round corners.
    void rounded(const glm::vec2& low, const glm::vec2& high, float radius, const glm::vec4& colour);
    void disc(const glm::vec2& middle, float radius, const glm::vec4& colour);
    /// Paints a straight tapering stroke.
    void stroke(const glm::vec2& from, const glm::vec2& to, const glm::vec2& widths, const glm::vec4& colour);

    Picture picture() const;

private:
    int _widthPx, _heightPx;
    glm::vec2 _originPx{0.0F}, _pixelsPerUnit{1.0F};
    std::vector<glm::vec4> _pixels;
};

} // namespace scenery::models
