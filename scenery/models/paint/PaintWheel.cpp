// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintWheel.h"

#include <cmath>
#include <numbers>

#include "scenery/models/paint/Canvas.h"

namespace scenery::models
{

Picture paintWheel()
{
    constexpr int kSizePx = 256;
    const glm::vec4 rubber(0.15F, 0.15F, 0.155F, 1.0F);
    const glm::vec4 alloy(0.66F, 0.67F, 0.69F, 1.0F);
    const glm::vec4 gap(0.12F, 0.12F, 0.13F, 1.0F);
    Canvas canvas(kSizePx, kSizePx, rubber);
    canvas.setFrame({128.0F, 128.0F}, {125.4F, 125.4F}); // the wheel's radius is 0.49 of the picture's side
    canvas.disc({0.0F, 0.0F}, 0.90F, {0.18F, 0.18F, 0.185F, 1.0F});
    canvas.disc({0.0F, 0.0F}, 0.86F, rubber);
    canvas.disc({0.0F, 0.0F}, 0.69F, alloy);
    canvas.disc({0.0F, 0.0F}, 0.61F, gap);
    const auto around = [](float turn) { return glm::vec2(std::cos(turn), std::sin(turn)); };
    for (int spoke = 0; spoke < 5; ++spoke)
        for (const float offset : {-0.16F, 0.16F})
        {
            const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(spoke) / 5.0F + 0.3F;
            canvas.stroke(around(turn) * 0.08F, around(turn + offset) * 0.64F, {0.12F, 0.10F}, alloy);
        }
    canvas.disc({0.0F, 0.0F}, 0.19F, alloy);
    canvas.disc({0.0F, 0.0F}, 0.08F, {0.45F, 0.46F, 0.48F, 1.0F});
    for (int bolt = 0; bolt < 5; ++bolt)
        canvas.disc(around(2.0F * std::numbers::pi_v<float> * static_cast<float>(bolt) / 5.0F) * 0.135F,
                    0.022F, gap);
    return canvas.picture();
}

} // namespace scenery::models
