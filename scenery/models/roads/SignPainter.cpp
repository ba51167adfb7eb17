// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/SignPainter.h"

#include <vector>

#include <glm/geometric.hpp>

#include "scenery/models/roads/StrokeFont.h"

namespace scenery::models
{

void SignPainter::ground(const glm::vec4& colour)
{
    _canvas.rectangle({-1.0F, -1.0F}, {1.0F, 1.0F}, colour);
}

void SignPainter::ring(const glm::vec4& rim, const glm::vec4& inside)
{
    ground(rim);
    disc({0.0F, 0.0F}, 0.74F, inside);
}

void SignPainter::triangle(bool pointsUp)
{
    ground(kRed);
    const float up = pointsUp ? 1.0F : -1.0F;
    fill({{-0.68F, -0.78F * up}, {0.68F, -0.78F * up}, {0.0F, 0.58F * up}}, kWhite);
}

void SignPainter::fill(std::initializer_list<glm::vec2> corners, const glm::vec4& colour)
{
    _canvas.polygon(std::vector<glm::vec2>(corners), colour);
}

void SignPainter::line(std::initializer_list<glm::vec2> points, float width, const glm::vec4& colour)
{
    const glm::vec2* from = nullptr;
    for (const glm::vec2& to : points)
    {
        if (from) _canvas.stroke(*from, to, glm::vec2(width), colour);
        disc(to, 0.5F * width, colour);
        from = &to;
    }
}

void SignPainter::arrow(const glm::vec2& from, const glm::vec2& to, const glm::vec4& colour)
{
    const glm::vec2 along = glm::normalize(to - from);
    const glm::vec2 across(-along.y, along.x);
    const glm::vec2 neck = to - 0.38F * along;
    _canvas.stroke(from, neck, glm::vec2(0.2F), colour);
    fill({to, neck + 0.32F * across, neck - 0.32F * across}, colour);
}

void SignPainter::person(const glm::vec2& foot, float height, const glm::vec4& colour)
{
    const auto at = [&](float x, float y) { return foot + height * glm::vec2(x, y); };
    disc(at(0.02F, 0.91F), 0.09F * height, colour);
    line({at(0.0F, 0.75F), at(0.0F, 0.45F)}, 0.16F * height, colour);
    line({at(0.0F, 0.45F), at(0.16F, 0.22F), at(0.14F, 0.02F)}, 0.09F * height, colour);
    line({at(0.0F, 0.45F), at(-0.08F, 0.24F), at(-0.24F, 0.04F)}, 0.09F * height, colour);
    line({at(0.0F, 0.76F), at(0.2F, 0.58F), at(0.3F, 0.6F)}, 0.07F * height, colour);
    line({at(0.0F, 0.76F), at(-0.18F, 0.56F)}, 0.07F * height, colour);
}

void SignPainter::car(const glm::vec2& middle, float width, const glm::vec4& colour)
{
    const auto at = [&](float x, float y) { return middle + width * glm::vec2(x, y); };
    fill({at(-0.5F, -0.2F), at(0.5F, -0.2F), at(0.5F, 0.1F), at(0.34F, 0.4F), at(-0.34F, 0.4F),
          at(-0.5F, 0.1F)},
         colour);
    for (const float x : {-0.36F, 0.36F})
        _canvas.rectangle(at(x - 0.1F, -0.38F), at(x + 0.1F, -0.1F), colour);
    fill({at(-0.34F, 0.1F), at(0.34F, 0.1F), at(0.25F, 0.3F), at(-0.25F, 0.3F)}, kWhite);
}

void SignPainter::text(std::string_view words, float height, const glm::vec4& colour)
{
    paintText(_canvas, {words, {0.0F, 0.0F}, height, 0.17F, colour});
}

} // namespace scenery::models
