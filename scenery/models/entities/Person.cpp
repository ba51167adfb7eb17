// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/Person.h"

#include <glm/geometric.hpp>

#include "scenery/models/entities/Loft.h"
#include "scenery/models/roads/SignAtlas.h"

namespace scenery::models
{

namespace
{

constexpr double kThighThick = 0.052, kKneeThick = 0.034,
                 kAnkleThick = 0.024; ///< radii, shares of the height

LoftRing across(double x, double z, double deep, double wide)
{
    return {{x, 0.0, z}, {deep, 0.0, 0.0}, {0.0, wide, 0.0}, 2.4};
}

void addShoe(ModelBuilder& builder, const PersonSize& size, const glm::dvec3& ankle)
{
    const double h = size.height, sole = ankle.z - size.ankle();
    const auto ring = [&](double x, double wide, double high) -> LoftRing
    {
        return {{ankle.x + x * h, ankle.y, sole + 0.5 * high * h},
                {0.0, wide * h, 0.0},
                {0.0, 0.0, 0.5 * high * h},
                3.0};
    };
    addLoft(builder,
            {ring(-0.045, 0.0, 0.02), ring(-0.043, 0.018, 0.035), ring(-0.01, 0.024, 0.048),
             ring(0.03, 0.026, 0.038), ring(0.085, 0.027, 0.026), ring(0.105, 0.018, 0.020),
             ring(0.109, 0.0, 0.014)},
            12);
}

} // namespace

void addTrunk(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours, bool helmet)
{
    const double h = size.height;
    builder.begin("hips", kPlain, colours.trousers);
    addLoft(builder,
            {across(0.0, -0.05 * h, 0.0, 0.0), across(0.0, -0.045 * h, 0.055 * h, 0.08 * h),
             across(0.0, 0.0, 0.068 * h, 0.098 * h), across(0.0, 0.045 * h, 0.060 * h, 0.092 * h),
             across(0.0, 0.05 * h, 0.0, 0.0)},
            16);
    builder.begin("jacket", kPlain, colours.jacket);
    addLoft(builder,
            {across(0.0, 0.01 * h, 0.0, 0.0), across(0.0, 0.012 * h, 0.070 * h, 0.100 * h),
             across(0.0, 0.10 * h, 0.064 * h, 0.094 * h), across(0.005 * h, 0.20 * h, 0.072 * h, 0.112 * h),
             across(0.0, 0.265 * h, 0.066 * h, 0.120 * h),
             across(-0.004 * h, 0.295 * h, 0.050 * h, 0.095 * h),
             across(-0.004 * h, 0.312 * h, 0.034 * h, 0.045 * h), across(-0.004 * h, 0.318 * h, 0.0, 0.0)},
            20);
    builder.begin("neck", kPlain, colours.skin);
    addLimb(builder, {0.0, 0.0, 0.30 * h}, {0.008 * h, 0.0, 0.36 * h}, 0.030 * h, 0.030 * h);
    builder.begin("head", kPlain, colours.skin);
    addLoft(builder,
            {across(0.014 * h, 0.335 * h, 0.0, 0.0), across(0.018 * h, 0.338 * h, 0.026 * h, 0.024 * h),
             across(0.014 * h, 0.365 * h, 0.046 * h, 0.038 * h),
             across(0.008 * h, 0.40 * h, 0.055 * h, 0.045 * h),
             across(0.006 * h, 0.43 * h, 0.050 * h, 0.043 * h),
             across(0.004 * h, 0.455 * h, 0.032 * h, 0.028 * h), across(0.004 * h, 0.463 * h, 0.0, 0.0)},
            16);
    const double thick = helmet ? 0.012 * h : 0.004 * h, low = helmet ? 0.395 * h : 0.405 * h;
    builder.begin("hair", kPlain, colours.hair);
    addLoft(builder,
            {across(-0.012 * h, low, 0.0, 0.0), across(-0.012 * h, low, 0.042 * h + thick, 0.044 * h + thick),
             across(-0.004 * h, 0.43 * h, 0.052 * h + thick, 0.045 * h + thick),
             across(0.0, 0.455 * h, 0.036 * h + thick, 0.032 * h + thick),
             across(0.0, 0.466 * h + thick, 0.0, 0.0)},
            16);
}

void addArm(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours,
            const glm::dvec3& shoulder, const glm::dvec3& elbow, const glm::dvec3& hand)
{
    const double h = size.height;
    builder.begin("sleeve", kPlain, colours.jacket);
    addLimb(builder, shoulder, elbow, 0.032 * h, 0.025 * h);
    const glm::dvec3 wrist = elbow + 0.62 * (hand - elbow);
    addLimb(builder, elbow, wrist, 0.025 * h, 0.019 * h);
    builder.begin("hand", kPlain, colours.skin);
    addLimb(builder, wrist, hand - 0.02 * h * glm::normalize(hand - wrist), 0.018 * h, 0.020 * h);
}

void addLeg(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours,
            const glm::dvec3& hip, const glm::dvec3& knee, const glm::dvec3& foot)
{
    const double h = size.height;
    builder.begin("trousers", kPlain, colours.trousers);
    addLimb(builder, hip, knee, kThighThick * h, kKneeThick * h);
    addLimb(builder, knee, foot, kKneeThick * h, kAnkleThick * h);
    builder.begin("shoe", kPlain, colours.shoes);
    addShoe(builder, size, foot);
}

Model makeThigh(const PersonSize& size, const PersonColours& colours)
{
    ModelBuilder builder;
    builder.begin("thigh", kPlain, colours.trousers);
    addLimb(builder, {}, {0.0, 0.0, -size.leg().upperM}, kThighThick * size.height, kKneeThick * size.height);
    return builder.finish();
}

Model makeShank(const PersonSize& size, const PersonColours& colours)
{
    ModelBuilder builder;
    builder.begin("shank", kPlain, colours.trousers);
    addLimb(builder, {}, {0.0, 0.0, -size.leg().lowerM}, kKneeThick * size.height, kAnkleThick * size.height);
    return builder.finish();
}

Model makeShoe(const PersonSize& size, const PersonColours& colours)
{
    ModelBuilder builder;
    builder.begin("shoe", kPlain, colours.shoes);
    addShoe(builder, size, {});
    return builder.finish();
}

} // namespace scenery::models
