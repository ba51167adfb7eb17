// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// A picture being painted: red, green, blue, alpha from 0 to 1, y upwards. What is painted covers all four channels, so that
/// an edge of a cut-out leaf keeps the leaf's colour instead of a dark rim.
/// Units: places and lengths in pixels times `scale` about `origin`, so that parts may be painted in metres.
class Canvas
{
public:
    Canvas(int widthPx, int heightPx, const glm::vec4& colour);

    /// What follows is in units of `pixelsPerUnit`, (0, 0) being at `originPx`.
    void setFrame(const glm::vec2& originPx, const glm::vec2& pixelsPerUnit);

    int widthPx() const { return _widthPx; }
    int heightPx() const { return _heightPx; }
    glm::vec4& pixel(int x, int y) { return _pixels[static_cast<std::size_t>(y) * _widthPx + x]; }

    /// A simple polygon, even-odd, edges smoothed over 4 × 4 samples a pixel.
    void polygon(std::span<const glm::vec2> corners, const glm::vec4& colour);
    void rectangle(const glm::vec2& low, const glm::vec2& high, const glm::vec4& colour);
    /// A rectangle whose corners are arcs.
    void rounded(const glm::vec2& low, const glm::vec2& high, float radius, const glm::vec4& colour);
    void disc(const glm::vec2& middle, float radius, const glm::vec4& colour);
    /// A straight stroke, tapering.
    void stroke(const glm::vec2& from, const glm::vec2& to, const glm::vec2& widths, const glm::vec4& colour);

    Picture picture() const;

private:
    int _widthPx, _heightPx;
    glm::vec2 _originPx{0.0F}, _pixelsPerUnit{1.0F};
    std::vector<glm::vec4> _pixels;
};

} // namespace scenery::models
