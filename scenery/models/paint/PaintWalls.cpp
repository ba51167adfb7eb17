// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintWalls.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "scenery/models/paint/Canvas.h"
#include "scenery/models/paint/Noise.h"

namespace scenery::models
{

namespace
{

constexpr int kWallSizePx = 256;

/// Paints a picture from a function that gives the colour at a place in the unit square.
template<class ColourAt>
Picture paintEach(const ColourAt& colourAt)
{
    Canvas canvas(kWallSizePx, kWallSizePx, glm::vec4(1.0F));
    for (int y = 0; y < kWallSizePx; ++y)
        for (int x = 0; x < kWallSizePx; ++x)
            canvas.pixel(x, y) =
                glm::vec4(colourAt((glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5F) /
                                   static_cast<float>(kWallSizePx)),
                          1.0F);
    return canvas.picture();
}

/// A place in a pattern of vertical strips: the number of the strip, and the share of its width.
struct Strip
{
    float number, across;
};

Strip stripAt(float u, int count)
{
    const float place = u * static_cast<float>(count);
    return {std::floor(place), place - std::floor(place)};
}

} // namespace

Picture paintPlaster()
{
    return paintEach(
        [](const glm::vec2& uv)
        {
            const float stain = tiledCloud(uv, {2, 2}, 3, 61);
            const float grain = tiledCloud(uv, {48, 48}, 2, 67);
            return glm::vec3(0.84F + 0.06F * stain + 0.07F * (grain - 0.5F));
        });
}

Picture paintBricks()
{
    return paintEach(
        [](const glm::vec2& uv)
        {
            constexpr int kCourses = 32; // 7.5 cm each
            const float course = std::floor(uv.y * kCourses);
            const float inCourse = uv.y * kCourses - course;
            const float shifted = uv.x * 10.0F + (static_cast<int>(course) % 2 == 0 ? 0.0F : 0.5F);
            const float inBrick = shifted - std::floor(shifted);
            if (inCourse < 0.14F || inBrick < 0.045F) return glm::vec3(0.62F, 0.60F, 0.56F);
            const float hue =
                tiledNoise({std::floor(shifted) / 10.0F, course / kCourses}, {10, kCourses}, 71);
            return glm::mix(glm::vec3(0.52F, 0.27F, 0.20F), glm::vec3(0.66F, 0.38F, 0.28F), hue);
        });
}

Picture paintSheetMetal()
{
    return paintEach(
        [](const glm::vec2& uv)
        {
            const Strip rib = stripAt(uv.x, 8);
            // The light comes from the left: the left flank of a rib is bright, the right one is in shade.
            const float shade = rib.across < 0.12F   ? 1.0F
                                : rib.across < 0.45F ? 0.92F
                                : rib.across < 0.57F ? 0.74F
                                                     : 0.84F;
            return glm::vec3(shade - 0.07F * tiledCloud(uv, {4, 3}, 3, 73));
        });
}

Picture paintPlanks()
{
    return paintEach(
        [](const glm::vec2& uv)
        {
            const Strip board = stripAt(uv.x, 14);
            if (board.across < 0.06F) return glm::vec3(0.20F, 0.17F, 0.15F);
            const float tone = tiledNoise({board.number / 14.0F, 0.0F}, {14, 1}, 79);
            const float grain = tiledCloud(uv + glm::vec2(0.0F, tone), {70, 3}, 2, 83);
            return glm::vec3(0.58F, 0.49F, 0.40F) * (0.72F + 0.30F * tone + 0.30F * (grain - 0.5F));
        });
}

} // namespace scenery::models
