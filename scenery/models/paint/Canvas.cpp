// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/Canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scenery::models
{

namespace
{

constexpr int kSamples = 4;

/// Sets `crossings` to the x at which a horizontal line crosses the polygon's edges, sorted.
void findCrossings(std::span<const glm::vec2> corners, float y, std::vector<float>& crossings)
{
    crossings.clear();
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const glm::vec2& a = corners[i];
        const glm::vec2& b = corners[(i + 1) % corners.size()];
        if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
    std::sort(crossings.begin(), crossings.end());
}

void addArc(std::vector<glm::vec2>& corners, const glm::vec2& middle, float radius, float fromTurn,
            float toTurn)
{
    const int steps = 8;
    for (int i = 0; i <= steps; ++i)
    {
        const float turn = fromTurn + (toTurn - fromTurn) * static_cast<float>(i) / steps;
        corners.push_back(middle + radius * glm::vec2(std::cos(turn), std::sin(turn)));
    }
}

} // namespace

Canvas::Canvas(int widthPx, int heightPx, const glm::vec4& colour)
    : _widthPx(widthPx), _heightPx(heightPx), _pixels(static_cast<std::size_t>(widthPx) * heightPx, colour)
{
}

void Canvas::setFrame(const glm::vec2& originPx, const glm::vec2& pixelsPerUnit)
{
    _originPx = originPx;
    _pixelsPerUnit = pixelsPerUnit;
}

void Canvas::polygon(std::span<const glm::vec2> corners, const glm::vec4& colour)
{
    std::vector<glm::vec2> px;
    float low = static_cast<float>(_heightPx);
    float high = 0.0F;
    for (const glm::vec2& corner : corners)
    {
        px.push_back(_originPx + corner * _pixelsPerUnit);
        low = std::min(low, px.back().y);
        high = std::max(high, px.back().y);
    }
    std::vector<float> crossings;
    std::vector<float> covered(static_cast<std::size_t>(_widthPx));
    const int last = std::min(static_cast<int>(std::ceil(high)), _heightPx);
    for (int y = std::max(static_cast<int>(std::floor(low)), 0); y < last; ++y)
    {
        std::fill(covered.begin(), covered.end(), 0.0F);
        for (int s = 0; s < kSamples; ++s)
        {
            findCrossings(px, static_cast<float>(y) + (static_cast<float>(s) + 0.5F) / kSamples, crossings);
            for (std::size_t c = 0; c + 1 < crossings.size(); c += 2)
            {
                const float from = std::clamp(crossings[c], 0.0F, static_cast<float>(_widthPx));
                const float to = std::clamp(crossings[c + 1], 0.0F, static_cast<float>(_widthPx));
                for (int x = static_cast<int>(from); static_cast<float>(x) < to; ++x)
                    covered[static_cast<std::size_t>(x)] +=
                        (std::min(to, static_cast<float>(x + 1)) - std::max(from, static_cast<float>(x))) /
                        kSamples;
            }
        }
        for (int x = 0; x < _widthPx; ++x)
            if (covered[static_cast<std::size_t>(x)] > 0.0F)
                pixel(x, y) =
                    glm::mix(pixel(x, y), colour, std::min(covered[static_cast<std::size_t>(x)], 1.0F));
    }
}

void Canvas::rectangle(const glm::vec2& low, const glm::vec2& high, const glm::vec4& colour)
{
    polygon(std::array{low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)}, colour);
}

void Canvas::rounded(const glm::vec2& low, const glm::vec2& high, float radius, const glm::vec4& colour)
{
    constexpr float kQuarter = std::numbers::pi_v<float> / 2.0F;
    std::vector<glm::vec2> corners;
    const glm::vec2 a = low + radius;
    const glm::vec2 b = high - radius;
    addArc(corners, b, radius, 0.0F, kQuarter);
    addArc(corners, {a.x, b.y}, radius, kQuarter, 2.0F * kQuarter);
    addArc(corners, a, radius, 2.0F * kQuarter, 3.0F * kQuarter);
    addArc(corners, {b.x, a.y}, radius, 3.0F * kQuarter, 4.0F * kQuarter);
    polygon(corners, colour);
}

void Canvas::disc(const glm::vec2& middle, float radius, const glm::vec4& colour)
{
    rounded(middle - radius, middle + radius, radius, colour);
}

void Canvas::stroke(const glm::vec2& from, const glm::vec2& to, const glm::vec2& widths,
                    const glm::vec4& colour)
{
    const glm::vec2 along = to - from;
    const glm::vec2 side = glm::normalize(glm::vec2(-along.y, along.x)) * 0.5F;
    polygon(std::array{from - side * widths.x, to - side * widths.y, to + side * widths.y,
                       from + side * widths.x},
            colour);
}

Picture Canvas::picture() const
{
    Picture picture{_widthPx, _heightPx, {}};
    picture.rgba.reserve(_pixels.size() * 4);
    for (const glm::vec4& colour : _pixels)
        for (int c = 0; c < 4; ++c)
            picture.rgba.push_back(
                static_cast<std::uint8_t>(std::clamp(colour[c], 0.0F, 1.0F) * 255.0F + 0.5F));
    return picture;
}

} // namespace scenery::models
