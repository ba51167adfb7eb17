// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintHouseDetails.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/paint/Canvas.h"
#include "scenery/models/paint/Noise.h"

namespace scenery::models
{

namespace
{

constexpr int kDetailCellPx = 256;
const glm::vec4 kWindowFrame(0.93F, 0.93F, 0.92F, 1.0F);
const glm::vec4 kSeam(0.30F, 0.30F, 0.30F, 1.0F);

/// Paints one cell of the atlas. Units of its functions: shares of the cell's size.
class CellPainter
{
public:
    CellPainter(Canvas& painted, Detail detail) : canvas(painted)
    {
        const auto number = static_cast<int>(detail);
        _corner = glm::ivec2(number % kDetailColumns, number / kDetailColumns) * kDetailCellPx;
        canvas.setFrame(glm::vec2(_corner), glm::vec2(kDetailCellPx));
    }

    void fill(const glm::vec3& colour, float tinted, float grain, const glm::ivec2& cells)
    {
        for (int y = 0; y < kDetailCellPx; ++y)
            for (int x = 0; x < kDetailCellPx; ++x)
            {
                const glm::vec2 uv(static_cast<float>(x) / kDetailCellPx,
                                   static_cast<float>(y) / kDetailCellPx);
                const float light = 1.0F + grain * (tiledCloud(uv, cells, 3, 103) - 0.5F);
                canvas.pixel(_corner.x + x, _corner.y + y) = glm::vec4(colour * light, tinted);
            }
    }

    /// Paints a pane: a dark room behind it, a reflection of the sky that is brighter towards the top, and a
    /// light slanting band.
    void glass(const glm::vec2& low, const glm::vec2& high, bool hasCurtain)
    {
        constexpr int kBands = 24;
        for (int i = 0; i < kBands; ++i)
        {
            const float t = static_cast<float>(i) / kBands;
            const glm::vec3 colour =
                glm::mix(glm::vec3(0.13F, 0.15F, 0.17F), glm::vec3(0.30F, 0.37F, 0.43F), t * t);
            const float y0 = glm::mix(low.y, high.y, t);
            const float y1 = glm::mix(low.y, high.y, t + 2.0F / kBands);
            canvas.rectangle({low.x, y0}, {high.x, std::min(y1, high.y)}, glm::vec4(colour, 0.0F));
        }
        if (!hasCurtain) return;
        const float wide = 0.26F * (high.x - low.x);
        for (const float x : {low.x, high.x - wide})
            for (int fold = 0; fold < 4; ++fold)
            {
                const float x0 = x + wide * static_cast<float>(fold) / 4.0F;
                const float tone = fold % 2 == 0 ? 0.56F : 0.48F;
                canvas.rectangle({x0, low.y}, {x0 + wide / 4.0F, high.y}, {tone, tone, tone * 0.96F, 0.0F});
            }
    }

    Canvas& canvas;

private:
    glm::ivec2 _corner;
};

/// Paints a window of sashes side by side, each with `rows` panes one above the other.
void paintWindow(Canvas& canvas, Detail detail, int sashes, int rows, bool hasCurtain)
{
    CellPainter cell(canvas, detail);
    cell.fill(glm::vec3(kWindowFrame), 1.0F, 0.04F, {8, 8});
    const float sash = 0.92F / static_cast<float>(sashes);
    for (int s = 0; s < sashes; ++s)
    {
        const float left = 0.04F + sash * static_cast<float>(s);
        canvas.rectangle({left + 0.004F, 0.03F}, {left + 0.014F, 0.97F}, {0.6F, 0.6F, 0.6F, 1.0F});
        const float rim = 0.11F * sash;
        const glm::vec2 low(left + rim, 0.08F);
        const glm::vec2 high(left + sash - rim, 0.93F);
        cell.glass(low, high, hasCurtain);
        for (int row = 1; row < rows; ++row)
        {
            const float y = glm::mix(low.y, high.y, static_cast<float>(row) / static_cast<float>(rows));
            canvas.rectangle({low.x, y - 0.012F}, {high.x, y + 0.012F}, kWindowFrame);
        }
    }
}

void paintDoors(Canvas& canvas)
{
    CellPainter door(canvas, Detail::door);
    door.fill(glm::vec3(0.95F), 1.0F, 0.08F, {24, 2});
    for (const float y : {0.06F, 0.52F})
        for (const float x : {0.14F, 0.54F})
        {
            canvas.rectangle({x, y}, {x + 0.32F, y + 0.38F}, {0.62F, 0.62F, 0.62F, 1.0F});
            canvas.rectangle({x + 0.025F, y + 0.02F}, {x + 0.30F, y + 0.35F}, {0.88F, 0.88F, 0.88F, 1.0F});
        }
    canvas.rounded({0.88F, 0.45F}, {0.93F, 0.51F}, 0.02F, {0.75F, 0.72F, 0.65F, 0.0F});
    CellPainter glassDoor(canvas, Detail::glassDoor);
    glassDoor.fill(glm::vec3(0.95F), 1.0F, 0.06F, {24, 2});
    canvas.rectangle({0.49F, 0.0F}, {0.51F, 0.76F}, kSeam);
    for (const float x : {0.08F, 0.55F})
        glassDoor.glass({x, 0.26F}, {x + 0.37F, 0.72F}, false);
    glassDoor.glass({0.06F, 0.79F}, {0.94F, 0.95F}, false);
    CellPainter gate(canvas, Detail::gate);
    gate.fill(glm::vec3(0.90F), 1.0F, 0.04F, {6, 6});
    for (int i = 1; i < 7; ++i)
        canvas.rectangle({0.0F, static_cast<float>(i) / 7.0F - 0.004F},
                         {1.0F, static_cast<float>(i) / 7.0F + 0.008F}, {0.5F, 0.5F, 0.5F, 1.0F});
    for (int i = 0; i < 5; ++i)
        gate.glass({0.06F + 0.185F * static_cast<float>(i), 0.46F},
                   {0.20F + 0.185F * static_cast<float>(i), 0.54F}, false);
    CellPainter barn(canvas, Detail::barnDoor);
    barn.fill(glm::vec3(0.60F, 0.50F, 0.41F), 1.0F, 0.5F, {24, 2});
    for (int i = 0; i <= 16; ++i)
        canvas.rectangle({static_cast<float>(i) / 16.0F - 0.003F, 0.0F},
                         {static_cast<float>(i) / 16.0F + 0.003F, 1.0F}, {0.2F, 0.17F, 0.14F, 1.0F});
    canvas.rectangle({0.492F, 0.0F}, {0.508F, 1.0F}, {0.10F, 0.09F, 0.08F, 1.0F});
    for (const float x : {0.02F, 0.52F})
    {
        const glm::vec4 brace(0.66F, 0.56F, 0.46F, 1.0F);
        for (const float y : {0.06F, 0.86F})
            canvas.rectangle({x, y}, {x + 0.46F, y + 0.08F}, brace);
        canvas.stroke({x + 0.02F, 0.14F}, {x + 0.44F, 0.86F}, {0.07F, 0.07F}, brace);
    }
}

} // namespace

Picture paintHouseDetails()
{
    Canvas canvas(kDetailCellPx * kDetailColumns, kDetailCellPx * kDetailColumns, glm::vec4(1.0F));
    paintWindow(canvas, Detail::window, 2, 1, true);
    paintWindow(canvas, Detail::barsWindow, 2, 3, true);
    paintWindow(canvas, Detail::hallWindow, 5, 1, false);
    paintWindow(canvas, Detail::shopFront, 3, 1, false);
    paintDoors(canvas);
    CellPainter(canvas, Detail::wood).fill({0.72F, 0.66F, 0.58F}, 1.0F, 0.35F, {2, 40});
    CellPainter(canvas, Detail::stone).fill({0.62F, 0.61F, 0.58F}, 1.0F, 0.30F, {12, 12});
    CellPainter(canvas, Detail::zinc).fill({0.56F, 0.58F, 0.60F}, 1.0F, 0.08F, {4, 4});
    CellPainter(canvas, Detail::white).fill({0.92F, 0.91F, 0.88F}, 1.0F, 0.06F, {8, 8});
    CellPainter(canvas, Detail::skylight).fill({0.78F, 0.82F, 0.84F}, 0.0F, 0.08F, {3, 3});
    CellPainter bricks(canvas, Detail::bricks);
    bricks.fill({0.58F, 0.34F, 0.26F}, 1.0F, 0.5F, {12, 24});
    for (int course = 0; course < 20; ++course)
    {
        const float y = static_cast<float>(course) / 20.0F;
        const glm::vec4 mortar(0.62F, 0.60F, 0.56F, 1.0F);
        canvas.rectangle({0.0F, y}, {1.0F, y + 0.008F}, mortar);
        for (int brick = 0; brick < 6; ++brick)
        {
            const float x = (static_cast<float>(brick) + (course % 2 == 0 ? 0.0F : 0.5F)) / 6.0F;
            canvas.rectangle({x, y}, {x + 0.012F, y + 0.05F}, mortar);
        }
    }
    return canvas.picture();
}

} // namespace scenery::models
