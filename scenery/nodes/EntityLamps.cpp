// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityLamps.h"

#include <algorithm>
#include <cmath>

#include <osg/Geode>

#include "scenery/nodes/LampQuads.h"
#include "scenery/nodes/RoadLamps.h"

namespace scenery
{

namespace
{

/// Returns the light of a lamp, linear: 1 is about that of a white wall in the sun.
osg::Vec4f lightOf(models::EntityLamp::Kind kind)
{
    using Kind = models::EntityLamp::Kind;
    switch (kind)
    {
    case Kind::head:
        return {1.5F, 1.45F, 1.25F, 1.0F};
    case Kind::tail:
        return {0.45F, 0.015F, 0.01F, 1.0F};
    case Kind::brake:
        return {1.4F, 0.05F, 0.03F, 1.0F};
    case Kind::indicatorLeft:
    case Kind::indicatorRight:
        return {1.4F, 0.50F, 0.02F, 1.0F};
    case Kind::warning:
        return {0.05F, 0.15F, 1.5F, 1.0F};
    case Kind::navigationRed:
    case Kind::beacon:
        return {1.5F, 0.05F, 0.03F, 1.0F};
    case Kind::navigationGreen:
        return {0.05F, 1.4F, 0.35F, 1.0F};
    case Kind::strobe:
    case Kind::landing:
        return {3.0F, 3.0F, 3.0F, 1.0F};
    default:
        return {1.2F, 1.2F, 1.15F, 1.0F};
    }
}

} // namespace

namespace
{

/// Whether a lamp that flashes once in a period is lit.
bool flashes(double timeS, double periodS, double litS)
{
    return timeS - std::floor(timeS / periodS) * periodS < litS;
}

models::LitLamps lampsOf(const simulation::AircraftParts& parts, double timeS)
{
    using Kind = models::EntityLamp::Kind;
    constexpr double kStrobePeriodS = 1.2, kBeaconPeriodS = 1.0, kFlashS = 0.1;
    const auto at = [](Kind kind) { return static_cast<std::size_t>(kind); };
    models::LitLamps lit{};
    for (const Kind kind : {Kind::navigationRed, Kind::navigationGreen, Kind::navigationWhite})
        lit[at(kind)] = parts.hasNavigationLights;
    lit[at(Kind::landing)] = parts.hasLandingLight;
    lit[at(Kind::strobe)] = parts.hasStrobes && flashes(timeS, kStrobePeriodS, kFlashS);
    lit[at(Kind::beacon)] =
        parts.hasBeacon && flashes(timeS + 0.5 * kBeaconPeriodS, kBeaconPeriodS, 2.0 * kFlashS);
    return lit;
}

/// The glow of a lamp: several strips that make up one lens share it.
osg::Vec3f glowOf(const models::EntityLamp& lamp)
{
    using Kind = models::EntityLamp::Kind;
    constexpr float kLensM2 = 0.02F, kPoint = 2.5F;
    const osg::Vec4f light = lightOf(lamp.kind);
    const float area = static_cast<float>(lamp.widthM * lamp.heightM);
    if (lamp.kind >= Kind::navigationRed) return osg::Vec3f(light.x(), light.y(), light.z()) * kPoint;
    const float strength = (lamp.kind == Kind::head ? 3.0F : 1.2F) * std::min(area / kLensM2, 1.0F);
    return osg::Vec3f(light.x(), light.y(), light.z()) * strength;
}

} // namespace

LightPoint lightPointOf(const models::EntityLamp& lamp)
{
    using Kind = models::EntityLamp::Kind;
    struct Shine
    {
        double candela;
        BeamKind beam;
    };
    const auto shine = [&]() -> Shine
    {
        switch (lamp.kind)
        {
        case Kind::head:
            return {13000.0, BeamKind::lowBeam};
        case Kind::tail:
            return {8.0, BeamKind::carRear};
        case Kind::brake:
            return {80.0, BeamKind::carRear};
        case Kind::warning:
            return {300.0, BeamKind::everywhere};
        case Kind::navigationRed:
            return {40.0, BeamKind::forwardLeft};
        case Kind::navigationGreen:
            return {40.0, BeamKind::forwardRight};
        case Kind::navigationWhite:
            return {20.0, BeamKind::rear};
        case Kind::strobe:
        case Kind::beacon:
            return {400.0, BeamKind::anticollision};
        case Kind::landing:
            return {200000.0, BeamKind::landing};
        default: // indicators and reversing lamps
            return {250.0, BeamKind::carRear};
        }
    }();
    constexpr double kLensM2 = 0.02; // strips that make up one lens share its light
    const double share =
        lamp.kind < Kind::navigationRed ? std::min(lamp.widthM * lamp.heightM / kLensM2, 1.0) : 1.0;
    const osg::Vec4f light = lightOf(lamp.kind);
    const float most = std::max({light.x(), light.y(), light.z()});
    LightPoint point;
    point.place = lamp.middle;
    point.colour = glm::vec3(light.x(), light.y(), light.z()) / most;
    point.candela = shine.candela * share;
    point.beam = shine.beam;
    point.group = LightGroup::vehicle;
    const bool isForward = shine.beam == BeamKind::forwardLeft || shine.beam == BeamKind::forwardRight;
    point.headingDeg = isForward || lamp.looksAhead ? 0.0 : 180.0;
    if (shine.beam == BeamKind::rear) point.headingDeg = 180.0;
    return point;
}

models::LitLamps defaultLamps(const simulation::EntityState& state, bool isDark, double timeS)
{
    using Kind = models::EntityLamp::Kind;
    if (state.aircraft) return lampsOf(*state.aircraft, timeS);
    constexpr double kBrakingMps2 = 0.5, kStandingMps = 0.05;
    const double ahead = glm::dot(state.acceleration, state.bodyToLocal()[0]);
    const auto at = [](Kind kind) { return static_cast<std::size_t>(kind); };
    models::LitLamps lit{};
    lit[at(Kind::brake)] = state.speedMps > kStandingMps && ahead < -kBrakingMps2;
    lit[at(Kind::reversing)] = state.speedMps < -kStandingMps;
    lit[at(Kind::head)] = lit[at(Kind::tail)] = isDark;
    return lit;
}

EntityLamps::EntityLamps(std::vector<models::EntityLamp> lamps) : _lamps(std::move(lamps))
{
    if (_lamps.empty()) return;
    const osg::ref_ptr<osg::Geometry> geometry = makeLampQuads(
        _lamps, *_colours,
        [](const models::EntityLamp& lamp, float across, float up)
        {
            const double ahead = lamp.looksAhead ? 1.0 : -1.0, aside = 0.5 * ahead * across;
            const osg::Vec3d at(lamp.middle.x + aside * lamp.sweepM, lamp.middle.y + aside * lamp.widthM,
                                lamp.middle.z + 0.5 * up * lamp.heightM);
            return LampCorner{osg::Vec3f(at), {static_cast<float>(ahead), 0.0F, 0.0F}};
        });
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    geode->getOrCreateStateSet()->setAttributeAndModes(makeRoadLampProgram());
    _glow.emplace(_lamps);
    _node = new osg::Group;
    _node->addChild(geode);
    _node->addChild(_glow->node());
    std::vector<LightPoint> points;
    for (const models::EntityLamp& lamp : _lamps)
        points.push_back(lightPointOf(lamp));
    _points.emplace(points, 0.0);
    _node->addChild(_points->node());
    _node->setNodeMask(0); // all are dark
}

void EntityLamps::light(const models::LitLamps& lit)
{
    if (!_node || lit == _lit) return;
    _lit = lit;
    bool isAnyLit = false;
    std::vector<osg::Vec3f> glows(_lamps.size());
    std::vector<float> shares(_lamps.size());
    for (std::size_t i = 0; i < _lamps.size(); ++i)
    {
        const bool isLit = lit[static_cast<std::size_t>(_lamps[i].kind)];
        isAnyLit = isAnyLit || isLit;
        if (isLit) glows[i] = glowOf(_lamps[i]);
        shares[i] = isLit ? 1.0F : 0.0F;
        for (std::size_t corner = 0; corner < kLampCorners.size(); ++corner)
            (*_colours)[kLampCorners.size() * i + corner] = isLit ? lightOf(_lamps[i].kind) : osg::Vec4f();
    }
    _colours->dirty();
    _glow->light(glows);
    _points->dim(shares);
    _node->setNodeMask(isAnyLit ? ~0U : 0U);
}

} // namespace scenery
