// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintBark.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "scenery/models/Dice.h"
#include "scenery/models/paint/Canvas.h"
#include "scenery/models/paint/Noise.h"

namespace scenery::models
{

namespace
{

constexpr int kBarkSizePx = 256;

struct Furrows
{
    glm::vec3 ridge, groove;
    glm::ivec2 cells; ///< cells of noise across and along the trunk; fewer along make longer furrows
    std::uint32_t seed;
};

Picture paintFurrows(const Furrows& look)
{
    Canvas canvas(kBarkSizePx, kBarkSizePx, glm::vec4(1.0F));
    for (int y = 0; y < kBarkSizePx; ++y)
        for (int x = 0; x < kBarkSizePx; ++x)
        {
            glm::vec2 uv(static_cast<float>(x) / kBarkSizePx, static_cast<float>(y) / kBarkSizePx);
            uv.x += 0.04F * (tiledNoise(uv, {4, 6}, look.seed + 9) - 0.5F); // makes the furrows wind
            const float wave = tiledCloud(uv, look.cells, 3, look.seed);
            const float grain = tiledCloud(uv, {32, 32}, 2, look.seed + 5);
            // Furrows follow the contour of the noise at its middle value, so they branch and join.
            const float height = glm::smoothstep(0.01F, 0.20F, std::abs(2.0F * wave - 1.0F));
            const glm::vec3 colour = glm::mix(look.groove, look.ridge, height) * (0.75F + 0.5F * grain);
            canvas.pixel(x, y) = glm::vec4(colour, 1.0F);
        }
    return canvas.picture();
}

} // namespace

Picture paintOakBark()
{
    return paintFurrows({{0.47F, 0.41F, 0.34F}, {0.22F, 0.18F, 0.15F}, {10, 3}, 3});
}

Picture paintPineBark()
{
    return paintFurrows({{0.42F, 0.33F, 0.28F}, {0.22F, 0.17F, 0.14F}, {8, 8}, 17});
}

Picture paintBirchBark()
{
    Canvas canvas(kBarkSizePx, kBarkSizePx, glm::vec4(1.0F));
    for (int y = 0; y < kBarkSizePx; ++y)
        for (int x = 0; x < kBarkSizePx; ++x)
        {
            const glm::vec2 uv(static_cast<float>(x) / kBarkSizePx, static_cast<float>(y) / kBarkSizePx);
            const float cloud = tiledCloud(uv, {3, 12}, 3, 31);
            canvas.pixel(x, y) = glm::vec4(
                glm::mix(glm::vec3(0.72F, 0.69F, 0.64F), glm::vec3(0.90F, 0.89F, 0.86F), cloud), 1.0F);
        }
    Dice dice(5);
    for (int i = 0; i < 70; ++i) // dark, horizontal lenticels and scars
    {
        const bool isScar = i < 9;
        const glm::vec2 middle(dice.between(0.0, kBarkSizePx), dice.between(6.0, kBarkSizePx - 6.0));
        const auto half = static_cast<float>(isScar ? dice.between(14.0, 30.0) : dice.between(3.0, 11.0));
        const auto thick = static_cast<float>(isScar ? dice.between(5.0, 10.0) : dice.between(1.2, 3.0));
        const glm::vec4 dark(0.17F, 0.15F, 0.14F, 1.0F);
        for (const float shift : {-static_cast<float>(kBarkSizePx), 0.0F, static_cast<float>(kBarkSizePx)})
        {
            const glm::vec2 at = middle + glm::vec2(shift, 0.0F);
            canvas.stroke(at - glm::vec2(half, 0.0F), at, {0.5F, thick}, dark);
            canvas.stroke(at, at + glm::vec2(half, 0.0F), {thick, 0.5F}, dark);
        }
    }
    return canvas.picture();
}

} // namespace scenery::models
