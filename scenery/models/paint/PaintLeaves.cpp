// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintLeaves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "scenery/models/Dice.h"
#include "scenery/models/paint/Canvas.h"

namespace scenery::models
{

namespace
{

constexpr int kLeavesSizePx = 512;

/// The appearance of a tree's leaves. Units: shares of the picture's width.
struct LeafLook
{
    glm::vec3 colour;
    float length, width;
    float widestAt; ///< position along the leaf, 0 stalk … 1 tip
    float lobes;    ///< number of waves of its edge; 0: smooth
    int leaves;
    float hanging; ///< 0: leaves point anywhere, 1: they hang down
    std::uint64_t seed;
};

glm::vec2 turned(const glm::vec2& v, float turn)
{
    return {v.x * std::cos(turn) - v.y * std::sin(turn), v.x * std::sin(turn) + v.y * std::cos(turn)};
}

void paintLeaf(Canvas& canvas, const LeafLook& look, const glm::vec2& stalk, const glm::vec2& along,
               const glm::vec3& colour)
{
    const glm::vec2 side(-along.y, along.x);
    std::vector<glm::vec2> left, outline;
    constexpr int kSteps = 14;
    for (int i = 0; i <= kSteps; ++i)
    {
        const float t = static_cast<float>(i) / kSteps;
        const float bent =
            std::pow(t, std::log(0.5F) / std::log(look.widestAt)); // a half at the widest place
        float half =
            0.5F * look.width * std::pow(std::max(std::sin(std::numbers::pi_v<float> * bent), 0.0F), 0.8F);
        half *= 1.0F + 0.28F * (look.lobes > 0.0F ? std::sin(6.2832F * look.lobes * t) : 0.0F);
        const glm::vec2 place = stalk + along * (t * look.length);
        outline.push_back(place - side * half);
        left.push_back(place + side * half);
    }
    outline.insert(outline.end(), left.rbegin(), left.rend());
    canvas.polygon(outline, glm::vec4(colour, 1.0F));
    // One half of the leaf is lighter, the rib is pale.
    outline.assign(left.rbegin(), left.rend());
    canvas.polygon(outline, glm::vec4(colour * 1.16F, 1.0F));
    canvas.stroke(stalk - along * (0.2F * look.length), stalk + along * (0.92F * look.length),
                  {0.05F * look.width, 0.02F * look.width}, glm::vec4(colour * 1.3F + 0.02F, 1.0F));
}

/// Paints twigs that fan out, and leaves scattered over an oval, which point more or less outwards. The first
/// leaves lie behind the others and are darker.
Picture paintCluster(const LeafLook& look)
{
    Canvas canvas(kLeavesSizePx, kLeavesSizePx, glm::vec4(look.colour, 0.0F));
    canvas.setFrame({0.5F * kLeavesSizePx, 0.0F}, glm::vec2(kLeavesSizePx));
    Dice dice(look.seed);
    const auto random = [&](double low, double high) { return static_cast<float>(dice.between(low, high)); };
    const glm::vec2 middle(0.0F, 0.52F);
    for (int twig = 0; twig < 7; ++twig)
    {
        const glm::vec2 tip = turned({0.0F, random(0.6, 0.85)}, 0.22F * static_cast<float>(twig - 3));
        canvas.stroke({0.0F, 0.0F}, tip, {0.012F, 0.004F}, {0.30F, 0.24F, 0.17F, 1.0F});
    }
    for (int leaf = 0; leaf < look.leaves; ++leaf)
    {
        const float share = static_cast<float>(leaf) / static_cast<float>(look.leaves);
        const float reach = std::sqrt(random(0.0, 1.0)) * (share < 0.3F ? 0.47F : 0.44F) * random(0.86, 1.0);
        const glm::vec2 outward = turned({0.0F, 1.0F}, random(0.0, 6.2832));
        glm::vec2 along =
            glm::normalize(turned(outward, random(-1.5, 1.5)) + glm::vec2(0.0F, 0.35F - 1.9F * look.hanging));
        const glm::vec2 centre = middle + outward * reach;
        const glm::vec2 stalk = centre - along * (0.5F * look.length);
        const glm::vec2 tip = centre + along * (0.5F * look.length);
        if (std::max(std::abs(stalk.x), std::abs(tip.x)) > 0.48F || std::max(stalk.y, tip.y) > 0.98F ||
            std::min(stalk.y, tip.y) < 0.02F)
            continue; // a leaf cut off by the edge of the card would be noticed
        const float shade = glm::mix(0.58F, 1.02F, share) * random(0.86, 1.14);
        const glm::vec3 hue = look.colour * glm::vec3(random(0.88, 1.16), 1.0F, random(0.8, 1.1));
        paintLeaf(canvas, look, stalk, along, hue * shade);
    }
    return canvas.picture();
}

} // namespace

Picture paintOakLeaves()
{
    return paintCluster({{0.30F, 0.40F, 0.18F}, 0.105F, 0.064F, 0.60F, 3.5F, 260, 0.0F, 11});
}

Picture paintBirchLeaves()
{
    return paintCluster({{0.36F, 0.46F, 0.21F}, 0.070F, 0.053F, 0.36F, 0.0F, 360, 0.35F, 23});
}

Picture paintPoplarLeaves()
{
    return paintCluster({{0.32F, 0.42F, 0.20F}, 0.080F, 0.070F, 0.38F, 0.0F, 290, 0.1F, 37});
}

Picture paintBushLeaves()
{
    return paintCluster({{0.29F, 0.39F, 0.19F}, 0.100F, 0.054F, 0.48F, 0.0F, 280, 0.0F, 41});
}

Picture paintSpruceNeedles()
{
    const glm::vec3 green(0.19F, 0.29F, 0.17F);
    Canvas canvas(kLeavesSizePx, kLeavesSizePx, glm::vec4(green, 0.0F));
    canvas.setFrame({0.5F * kLeavesSizePx, 0.0F}, glm::vec2(kLeavesSizePx));
    Dice dice(53);
    const auto random = [&](double low, double high) { return static_cast<float>(dice.between(low, high)); };
    const glm::vec4 wood(0.31F, 0.23F, 0.16F, 1.0F);
    const auto paintTwig = [&](const glm::vec2& from, const glm::vec2& direction, float length, float light)
    {
        canvas.stroke(from, from + direction * length, {0.014F, 0.006F}, wood);
        const int needles = static_cast<int>(length * 190.0F);
        for (int i = 0; i < needles; ++i)
        {
            const float t = (static_cast<float>(i) + random(0.0, 1.0)) / static_cast<float>(needles);
            const float turn = (i % 2 == 0 ? 1.0F : -1.0F) * random(0.45, 1.1);
            const glm::vec2 stalk = from + direction * (length * t);
            const glm::vec2 tip = stalk + turned(direction, turn) * random(0.045, 0.062);
            const glm::vec3 colour = green * light * random(0.75, 1.3);
            canvas.stroke(stalk, tip, {0.0095F, 0.005F}, glm::vec4(colour, 1.0F));
        }
    };
    for (int layer = 0; layer < 2; ++layer)
    {
        for (int pair = 0; pair < 7; ++pair)
            for (const float side : {-1.0F, 1.0F})
            {
                const float t = (static_cast<float>(pair) + random(0.2, 0.8)) / 7.6F;
                const float reach = (0.46F - 0.34F * t) * random(0.75, 1.0);
                paintTwig({0.0F, 0.02F + 0.84F * t}, turned({0.0F, 1.0F}, side * random(0.75, 1.0)), reach,
                          layer == 0 ? 0.72F : 1.05F);
            }
        paintTwig({0.0F, 0.0F}, {0.0F, 1.0F}, 0.93F, 1.1F);
    }
    return canvas.picture();
}

} // namespace scenery::models
