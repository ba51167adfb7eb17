// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

void addDelineator(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 1.05);
    builder.begin("post", kPlain, {0.95F, 0.95F, 0.93F});
    box(builder, {-0.06, -0.05, -0.3}, {0.06, 0.05, high - 0.32});
    builder.begin("cap", kPlain, {0.95F, 0.95F, 0.93F});
    box(builder, {-0.06, -0.05, high - 0.08}, {0.06, 0.05, high});
    builder.begin("band", kPlain, {0.07F, 0.07F, 0.08F});
    box(builder, {-0.06, -0.05, high - 0.32}, {0.06, 0.05, high - 0.08});
    builder.begin("reflector", kPlain, {0.98F, 0.98F, 0.98F});
    box(builder, {-0.068, -0.025, high - 0.28}, {-0.06, 0.025, high - 0.12});
}

void addLampPost(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 8.0);
    builder.begin("post", kPlain, kZinc);
    addTube(builder,
            {{{0.0, 0.0, -kPostDepthM}, {0.0, 0.0, high - 0.6}, {0.0, 0.3, high - 0.15}, {0.0, 1.2, high}},
             {0.09, 0.06, 0.05, 0.04},
             8,
             {0.0, 0.0},
             0.0,
             {}});
    builder.begin("luminaire", kPlain, {0.45F, 0.46F, 0.47F});
    box(builder, {-0.14, 1.1, high - 0.06}, {0.14, 1.75, high + 0.06});
}

void addCone(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 0.75);
    builder.begin("foot", kPlain, {0.12F, 0.12F, 0.12F});
    box(builder, {-0.2, -0.2, 0.0}, {0.2, 0.2, 0.04});
    for (int band = 0; band < 4; ++band)
    {
        const double from = 0.04 + (high - 0.04) * band / 4.0, to = 0.04 + (high - 0.04) * (band + 1) / 4.0;
        const auto radiusAt = [&](double z) { return 0.15 - 0.125 * z / high; };
        builder.begin("band " + std::to_string(band), kPlain,
                      band % 2 == 0 ? glm::vec3(0.92F, 0.28F, 0.05F) : glm::vec3(0.95F, 0.95F, 0.94F));
        addTube(
            builder,
            {{{0.0, 0.0, from}, {0.0, 0.0, to}}, {radiusAt(from), radiusAt(to)}, 12, {0.0, 0.0}, 0.0, {}});
    }
}

void addBollard(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 0.9), radius = orElse(0.5 * model.widthM, 0.06);
    builder.begin("post", kPlain, {0.35F, 0.36F, 0.37F});
    bar(builder, {0.0, 0.0, -0.3}, {0.0, 0.0, 0.78 * high}, radius);
    builder.begin("band", kPlain, {0.95F, 0.95F, 0.93F});
    bar(builder, {0.0, 0.0, 0.78 * high}, {0.0, 0.0, 0.9 * high}, 1.02 * radius);
    builder.begin("cap", kPlain, {0.35F, 0.36F, 0.37F});
    addTube(builder, {{{0.0, 0.0, 0.9 * high}, {0.0, 0.0, 0.97 * high}, {0.0, 0.0, high}},
                      {radius, 0.8 * radius, 0.3 * radius},
                      8,
                      {0.0, 0.0},
                      0.0,
                      {}});
}

void addRailPost(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 0.7);
    // A channel, open against the traffic: a web and two flanges.
    builder.begin("post", kPlain, {0.50F, 0.52F, 0.53F});
    box(builder, {-0.06, 0.035, -0.6}, {0.06, 0.040, high});
    builder.begin("flanges", kPlain, {0.50F, 0.52F, 0.53F});
    box(builder, {-0.06, -0.040, -0.6}, {-0.055, 0.034, high});
    box(builder, {0.055, -0.040, -0.6}, {0.06, 0.034, high});
}

void addGantry(ModelBuilder& builder, const RoadModel& model)
{
    const double half = 0.5 * orElse(model.widthM, 15.0), low = orElse(model.heightM, 6.0), high = low + 0.9;
    builder.begin("posts", kPlain, kZinc);
    for (const double side : {-half, half})
        box(builder, {-0.2, side - 0.2, -kPostDepthM}, {0.2, side + 0.2, high});
    // A truss: two chords in front, two behind, and diagonals between them.
    builder.begin("chords", kPlain, kZinc);
    for (const double x : {-0.35, 0.35})
        for (const double z : {low + 0.06, high - 0.06})
            bar(builder, {x, -half, z}, {x, half, z}, 0.06);
    builder.begin("diagonals", kPlain, kZinc);
    const int bays = std::max(2, static_cast<int>(std::lround(2.0 * half / 1.2)));
    for (int i = 0; i < bays; ++i)
    {
        const double from = -half + 2.0 * half * i / bays, to = -half + 2.0 * half * (i + 1) / bays;
        const double a = i % 2 == 0 ? low + 0.06 : high - 0.06, b = i % 2 == 0 ? high - 0.06 : low + 0.06;
        for (const double x : {-0.35, 0.35})
            bar(builder, {x, from, a}, {x, to, b}, 0.03);
    }
}

} // namespace scenery::models
