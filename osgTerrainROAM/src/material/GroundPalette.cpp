// SPDX-License-Identifier: Apache-2.0
#include "GroundPalette.h"

#include <algorithm>
#include <cmath>

#include <osgSky/MixedColour>

namespace osgTerrainROAM
{

namespace
{

using osgSky::mixed;

/// One month in temperate latitudes.
struct Month
{
    float bare, autumn;     ///< shares of fallen and of coloured leaves
    float pale;             ///< share of withered grass
    float snowShiftM;       ///< added to the snow line of early summer
    osg::Vec3f cereal, row; ///< crops
};

const std::array<Month, 12>& months()
{
    static const osg::Vec3f kYoung(0.066f, 0.102f, 0.025f), kGreen(0.106f, 0.126f, 0.038f),
        kRipe(0.330f, 0.250f, 0.095f);
    static const osg::Vec3f kStubble(0.250f, 0.205f, 0.110f), kEarth(0.140f, 0.108f, 0.078f);
    static const osg::Vec3f kLeaves(0.056f, 0.090f, 0.023f), kSprouts(0.105f, 0.100f, 0.052f),
        kDry(0.190f, 0.145f, 0.080f);
    static const std::array<Month, 12> table{
        {{1.0f, 0.0f, 0.75f, -2300.0f, mixed(kEarth, kYoung, 0.5f), kEarth},
         {1.0f, 0.0f, 0.80f, -2400.0f, mixed(kEarth, kYoung, 0.5f), kEarth},
         {0.9f, 0.0f, 0.65f, -1800.0f, mixed(kEarth, kYoung, 0.7f), kEarth},
         {0.5f, 0.0f, 0.25f, -1000.0f, kYoung, kEarth},
         {0.0f, 0.0f, 0.00f, -350.0f, mixed(kYoung, kGreen, 0.4f), kSprouts},
         {0.0f, 0.0f, 0.00f, 0.0f, kGreen, kLeaves},
         {0.0f, 0.0f, 0.15f, 350.0f, kRipe, kLeaves},
         {0.0f, 0.0f, 0.35f, 600.0f, kStubble, kLeaves},
         {0.0f, 0.25f, 0.35f, 450.0f, kEarth, mixed(kLeaves, kDry, 0.5f)},
         {0.15f, 0.95f, 0.40f, -200.0f, mixed(kEarth, kYoung, 0.3f), kDry},
         {0.75f, 0.60f, 0.60f, -1200.0f, mixed(kEarth, kYoung, 0.5f), kEarth},
         {1.0f, 0.0f, 0.70f, -2000.0f, mixed(kEarth, kYoung, 0.5f), kEarth}}};
    return table;
}

Month monthAt(double yearShare)
{
    const double place = (yearShare - std::floor(yearShare)) * 12.0 - 0.5 + 12.0;
    const auto first = static_cast<std::size_t>(std::floor(place));
    const auto t = static_cast<float>(place - std::floor(place));
    const Month &a = months()[first % 12], &b = months()[(first + 1) % 12];
    return {std::lerp(a.bare, b.bare, t), std::lerp(a.autumn, b.autumn, t),
            std::lerp(a.pale, b.pale, t), std::lerp(a.snowShiftM, b.snowShiftM, t),
            mixed(a.cereal, b.cereal, t), mixed(a.row, b.row, t)};
}

/// The colours of a climate in early summer.
GroundPalette earlySummer(const Climate& climate)
{
    const auto dry = static_cast<float>(std::clamp((climate.aridity - 0.15) / 0.7, 0.0, 1.0));
    const auto of = [dry](const osg::Vec3f& humid, const osg::Vec3f& arid)
    { return humid * (1.0f - dry) + arid * dry; };
    GroundPalette palette;
    palette.rock = of({0.200f, 0.190f, 0.180f}, {0.300f, 0.175f, 0.110f});
    palette.soil = of({0.175f, 0.150f, 0.115f}, {0.370f, 0.245f, 0.155f});
    palette.dryGrass = of({0.138f, 0.137f, 0.060f}, {0.330f, 0.260f, 0.150f});
    palette.meadow = of({0.064f, 0.100f, 0.027f}, {0.200f, 0.190f, 0.095f});
    palette.forest = of({0.032f, 0.056f, 0.022f}, {0.080f, 0.095f, 0.045f});
    palette.sand = of({0.380f, 0.320f, 0.225f}, {0.420f, 0.330f, 0.220f});
    palette.snow = of({0.830f, 0.845f, 0.860f}, {0.830f, 0.845f, 0.860f});
    palette.water = of({0.012f, 0.040f, 0.055f}, {0.015f, 0.045f, 0.055f});
    palette.crops = {osg::Vec3f(0.106f, 0.126f, 0.038f), osg::Vec3f(0.056f, 0.090f, 0.023f),
                     osg::Vec3f(0.070f, 0.112f, 0.029f), osg::Vec3f(0.042f, 0.070f, 0.021f)};
    palette.fieldSoil = of({0.135f, 0.105f, 0.075f}, {0.280f, 0.195f, 0.130f});
    return palette;
}

} // namespace

GroundPalette groundPalette(const Climate& climate, std::optional<double> yearShare)
{
    GroundPalette palette = earlySummer(climate);
    if (!yearShare) return palette;
    const Month month = monthAt(*yearShare + (climate.latitudeDeg < 0.0 ? 0.5 : 0.0));
    const auto much = static_cast<float>(std::clamp((std::abs(climate.latitudeDeg) - 10.0) / 30.0, 0.0, 1.0));
    const osg::Vec3f turned(0.150f, 0.085f, 0.022f), twigs(0.078f, 0.064f, 0.050f),
        straw(0.155f, 0.135f, 0.080f);
    // Half of the trees are evergreen.
    const auto leaves = [&](const osg::Vec3f& green)
    { return mixed(mixed(green, turned, 0.55f * much * month.autumn), twigs, 0.55f * much * month.bare); };
    palette.forest = leaves(palette.forest);
    palette.meadow = mixed(palette.meadow, straw, 0.8f * much * month.pale);
    palette.dryGrass = mixed(palette.dryGrass, straw, 0.6f * much * month.pale);
    palette.crops[0] = mixed(palette.crops[0], month.cereal, much);
    palette.crops[1] = mixed(palette.crops[1], month.row, much);
    palette.crops[2] = mixed(palette.crops[2], straw, 0.6f * much * month.pale);
    palette.crops[3] = leaves(palette.crops[3]);
    palette.snowShiftM = month.snowShiftM * much;
    return palette;
}

std::array<KindLook, core::kGroundKinds> kindLooks(const GroundPalette& p)
{
    const osg::Vec3f stone(0.190f, 0.185f, 0.180f), roofs(0.200f, 0.110f, 0.080f);
    std::array<KindLook, core::kGroundKinds> looks;
    const auto set = [&](core::GroundKind kind, const KindLook& look)
    { looks[static_cast<std::size_t>(kind)] = look; };
    using enum core::GroundKind;
    set(rock, {p.rock, 0.0f, p.rock * 0.75f, 0.4f});
    set(soil, {p.soil, 0.0f, p.dryGrass, 0.2f});
    set(dryGrass, {p.dryGrass, 0.0f, p.soil, 0.2f});
    set(meadow, {p.meadow, 0.0f, p.dryGrass, 0.2f});
    set(shrub, {mixed(p.forest, p.dryGrass, 0.45f), 0.4f, p.dryGrass, 0.4f});
    set(forest, {p.forest, 1.0f, mixed(p.forest, p.meadow, 0.25f), 0.4f});
    set(sand, {p.sand, 0.0f, p.sand * 0.85f, 0.3f});
    set(snow, {p.snow, 0.0f, p.snow, 0.0f});
    set(water, {p.water, 0.0f, p.water, 0.0f});
    set(crop, {mixed(p.crops[0], p.crops[1], 0.4f), 0.0f, mixed(p.crops[2], p.fieldSoil, 0.4f), 0.4f});
    set(urban, {mixed(stone, p.meadow, 0.3f), 0.1f, roofs, 0.35f});
    // Trees and hedges between lawns, seen from farther than they are drawn; beds and gravel.
    set(garden, {mixed(p.meadow, p.forest, 0.75f), 0.45f,
                 mixed(mixed(p.fieldSoil, stone, 0.5f), p.meadow, 0.45f), 0.2f});
    set(yard, {mixed(stone, p.fieldSoil, 0.35f), 0.0f, mixed(p.meadow, p.forest, 0.5f), 0.3f});
    set(wetland, {mixed(p.meadow, p.water, 0.35f), 0.0f, mixed(p.dryGrass, p.water, 0.6f), 0.4f});
    return looks;
}

} // namespace osgTerrainROAM
