// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintRoofs.h"

#include <cmath>
#include <numbers>

#include <glm/vec3.hpp>

#include "scenery/models/paint/Canvas.h"
#include "scenery/models/paint/Noise.h"

namespace scenery::models
{

namespace
{

constexpr int kRoofSizePx = 256;

float fraction(float v)
{
    return v - std::floor(v);
}

} // namespace

Picture paintRoofTiles()
{
    constexpr int kAcross = 10; // tiles are 24 cm wide and 30 cm high
    constexpr int kUp = 8;
    Canvas canvas(kRoofSizePx, kRoofSizePx, glm::vec4(1.0F));
    for (int y = 0; y < kRoofSizePx; ++y)
        for (int x = 0; x < kRoofSizePx; ++x)
        {
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / kRoofSizePx,
                               (static_cast<float>(y) + 0.5F) / kRoofSizePx);
            const float row = std::floor(uv.y * kUp);
            const float up = fraction(uv.y * kUp);         // share of the tile's height, from its lower edge
            const float across = fraction(uv.x * kAcross); // share of the tile's width
            const float wave = std::sin(across * 2.0F * std::numbers::pi_v<float>);
            float light = 0.86F + 0.12F * wave;
            if (up < 0.10F) light *= 0.55F; // the shadow of the row above
            if (up > 0.90F) light *= 1.12F; // the rounded edge
            const float tone =
                tiledNoise({std::floor(uv.x * kAcross) / kAcross, row / kUp}, {kAcross, kUp}, 91);
            light *= 0.86F + 0.22F * tone;
            light *= 0.92F + 0.12F * tiledCloud(uv, {3, 3}, 3, 97); // lichen and weather
            canvas.pixel(x, y) = glm::vec4(glm::vec3(light), 1.0F);
        }
    return canvas.picture();
}

Picture paintRoofMetal()
{
    Canvas canvas(kRoofSizePx, kRoofSizePx, glm::vec4(1.0F));
    for (int y = 0; y < kRoofSizePx; ++y)
        for (int x = 0; x < kRoofSizePx; ++x)
        {
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / kRoofSizePx,
                               (static_cast<float>(y) + 0.5F) / kRoofSizePx);
            const float across = fraction(uv.x * 8.0F);
            const float shade = across < 0.12F ? 1.0F : across < 0.24F ? 0.72F : 0.86F;
            const float streak = tiledCloud(uv, {24, 2}, 2, 101);
            canvas.pixel(x, y) = glm::vec4(glm::vec3(0.82F, 0.83F, 0.84F) * (shade - 0.12F * streak), 1.0F);
        }
    return canvas.picture();
}

} // namespace scenery::models
