// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/RunwayLights.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace scenery
{

namespace
{

constexpr double kHighCd = 10000.0, kMediumCd = 1000.0, kApproachCd = 20000.0, kSimpleCd = 5000.0,
                 kInsetCd = 5000.0, kTaxiwayCd = 30.0, kBeaconCd = 4000.0, kObstacleCd = 32.0;
constexpr double kLampM = 0.35; ///< above the ground
constexpr double kEdgeEveryM = 60.0, kEdgeOutM = 1.5, kTaxiwayOutM = 1.5;
constexpr double kApproachFall = 1.0 / 66.0;
const glm::vec3 kWhite(1.0F, 0.93F, 0.80F), kYellow(1.0F, 0.68F, 0.14F), kGreen(0.10F, 1.0F, 0.36F),
    kRed(1.0F, 0.05F, 0.03F), kBlue(0.10F, 0.22F, 1.0F), kFlashWhite(0.92F, 0.96F, 1.0F);

/// One direction of a runway: from the threshold at which one lands.
class Direction
{
public:
    Direction(const RunwayPlan& runway, bool isTurned, const foundation::HeightInPlan& ground)
        : _threshold(isTurned ? runway.to : runway.from),
          _lengthM(glm::distance(runway.from, runway.to)),
          _halfM(0.5 * runway.widthM),
          _along((isTurned ? runway.from - runway.to : runway.to - runway.from) / _lengthM),
          _class(classOf(runway)),
          _ground(ground)
    {
    }

    std::vector<LightPoint> lights()
    {
        if (_class == RunwayClass::unlit) return {};
        edges();
        ends();
        if (_class == RunwayClass::nonPrecision) simpleApproach();
        if (_class >= RunwayClass::precision) precisionApproach();
        if (_class == RunwayClass::precisionTwo)
        {
            centreLine();
            touchdownZone();
        }
        return std::move(_lights);
    }

private:
    glm::dvec2 at(double alongM, double leftM) const
    {
        return _threshold + alongM * _along + leftM * glm::dvec2(-_along.y, _along.x);
    }

    /// A lamp that shines towards those who come, `alongM` behind the threshold.
    LightPoint lamp(LightGroup group, BeamKind beam, double candela, const glm::vec3& colour) const
    {
        LightPoint light;
        light.group = group;
        light.beam = beam;
        light.candela = candela;
        light.colour = colour;
        light.tiltDeg = beam == BeamKind::approach ? 5.5 : 3.5;
        light.headingDeg = glm::degrees(std::atan2(-_along.y, -_along.x));
        return light;
    }

    void add(LightPoint light, double alongM, double leftM)
    {
        const glm::dvec2 place = at(alongM, leftM);
        const auto groundM = _ground(place);
        if (!groundM) return;
        light.place = {place, *groundM + kLampM};
        if (alongM < 0.0)
        {
            const auto thresholdM = _ground(_threshold);
            if (thresholdM)
                light.place.z = std::max(light.place.z, *thresholdM + kLampM + kApproachFall * alongM);
        }
        _lights.push_back(light);
    }

    /// A row across, `wideM` from its first to its last lamp.
    void row(const LightPoint& light, double alongM, double wideM, int count)
    {
        for (int i = 0; i < count; ++i)
            add(light, alongM, wideM * (static_cast<double>(i) / (count - 1) - 0.5));
    }

    void edges()
    {
        const int count = static_cast<int>(std::ceil(_lengthM / kEdgeEveryM));
        const double yellowM = std::min(600.0, _lengthM / 3.0);
        const bool isHigh = _class > RunwayClass::visual;
        for (int i = 0; i <= count; ++i)
            for (const double side : {-1.0, 1.0})
            {
                const double alongM = _lengthM * i / count;
                const bool isYellow = isHigh && _lengthM - alongM < yellowM;
                add(lamp(LightGroup::runway, BeamKind::runwayEdge, isHigh ? kHighCd : kMediumCd,
                         isYellow ? kYellow : kWhite),
                    alongM, side * (_halfM + kEdgeOutM));
            }
    }

    /// The threshold, and the end of this direction, whose lamps shine back to the threshold.
    void ends()
    {
        const bool isPrecise = _class >= RunwayClass::precision;
        const double wideM = 2.0 * (_halfM + kEdgeOutM);
        const double candela = _class > RunwayClass::visual ? kHighCd : kMediumCd;
        row(lamp(LightGroup::runway, BeamKind::threshold, candela, kGreen), -1.0, wideM,
            isPrecise ? static_cast<int>(std::ceil(wideM / 3.0)) + 1 : 6);
        row(lamp(LightGroup::runway, BeamKind::inset, 0.25 * candela, kRed), _lengthM + 1.0, wideM, 6);
    }

    void simpleApproach()
    {
        const LightPoint light = lamp(LightGroup::approach, BeamKind::approach, kSimpleCd, kWhite);
        for (double outM = 60.0; outM <= 420.0; outM += 60.0)
            row(light, -outM, 3.0, 3);
        row(light, -300.0, 30.0, 11);
    }

    void precisionApproach()
    {
        const LightPoint light = lamp(LightGroup::approach, BeamKind::approach, kApproachCd, kWhite);
        for (int i = 1; i <= 30; ++i)
        {
            row(light, -30.0 * i, 4.0, 5);
            if (i <= 10) continue;
            LightPoint flashing = light; // twice a second, one after the other towards the threshold
            flashing.colour = kFlashWhite;
            flashing.flash = {0.5, 0.5 * (30 - i) / 20.0, 0.045};
            add(flashing, -30.0 * i, 0.0);
        }
        row(light, -300.0, 30.0, 13);
    }

    void centreLine()
    {
        for (double alongM = 15.0; alongM < _lengthM; alongM += 15.0)
        {
            const double restM = _lengthM - alongM;
            const bool isRed = restM <= 300.0 || (restM <= 900.0 && std::fmod(alongM, 60.0) >= 30.0);
            add(lamp(LightGroup::centreLine, BeamKind::inset, kInsetCd, isRed ? kRed : kWhite), alongM, 0.6);
        }
    }

    void touchdownZone()
    {
        const LightPoint light = lamp(LightGroup::touchdownZone, BeamKind::inset, kInsetCd, kWhite);
        for (double alongM = 60.0; alongM <= std::min(900.0, 0.5 * _lengthM); alongM += 60.0)
            for (const double side : {-1.0, 1.0})
                for (const double leftM : {9.0, 10.5, 12.0})
                    add(light, alongM, side * leftM);
    }

    glm::dvec2 _threshold;
    double _lengthM, _halfM;
    glm::dvec2 _along;
    RunwayClass _class;
    const foundation::HeightInPlan& _ground;
    std::vector<LightPoint> _lights;
};

bool isOn(const RunwayPlan& runway, const glm::dvec2& place)
{
    const double lengthM = glm::distance(runway.from, runway.to);
    const glm::dvec2 along = (runway.to - runway.from) / lengthM, from = place - runway.from;
    const double alongM = glm::dot(from, along), asideM = along.x * from.y - along.y * from.x;
    return alongM > -5.0 && alongM < lengthM + 5.0 && std::abs(asideM) < 0.5 * runway.widthM + 1.0;
}

} // namespace

RunwayClass classOf(const RunwayPlan& runway)
{
    const double lengthM = glm::distance(runway.from, runway.to);
    if (!runway.isPaved || lengthM < 600.0) return RunwayClass::unlit;
    if (lengthM < 1200.0) return RunwayClass::visual;
    if (lengthM < 1800.0) return RunwayClass::nonPrecision;
    return lengthM < 2400.0 || runway.widthM < 45.0 ? RunwayClass::precision : RunwayClass::precisionTwo;
}

std::vector<LightPoint> runwayLights(const RunwayPlan& runway, const foundation::HeightInPlan& ground)
{
    std::vector<LightPoint> lights = Direction(runway, false, ground).lights();
    const std::vector<LightPoint> others = Direction(runway, true, ground).lights();
    lights.insert(lights.end(), others.begin(), others.end());
    return lights;
}

std::vector<LightPoint> taxiwayLights(std::span<const glm::dvec2> middle, double widthM,
                                      std::span<const RunwayPlan> runways,
                                      const foundation::HeightInPlan& ground)
{
    std::vector<LightPoint> lights;
    LightPoint light;
    light.group = LightGroup::taxiway;
    light.beam = BeamKind::above;
    light.candela = kTaxiwayCd;
    light.colour = kBlue;
    for (std::size_t i = 0; i + 1 < middle.size(); ++i)
    {
        const double lengthM = glm::distance(middle[i], middle[i + 1]);
        if (lengthM < 1.0) continue;
        const glm::dvec2 along = (middle[i + 1] - middle[i]) / lengthM, left(-along.y, along.x);
        const int count = std::max(1, static_cast<int>(std::ceil(lengthM / kEdgeEveryM)));
        for (int k = 0; k < count; ++k)
            for (const double side : {-1.0, 1.0})
            {
                const glm::dvec2 place = middle[i] + along * (lengthM * (k + 0.5) / count) +
                                         left * (side * (0.5 * widthM + kTaxiwayOutM));
                const auto groundM = ground(place);
                if (!groundM || std::any_of(runways.begin(), runways.end(),
                                            [&](const RunwayPlan& runway) { return isOn(runway, place); }))
                    continue;
                light.place = {place, *groundM + kLampM};
                lights.push_back(light);
            }
    }
    return lights;
}

std::vector<LightPoint> beaconLights(const glm::dvec3& place)
{
    LightPoint white;
    white.place = place;
    white.group = LightGroup::beacon;
    white.beam = BeamKind::above;
    white.candela = kBeaconCd;
    white.colour = kFlashWhite;
    white.flash = {5.0, 0.0, 0.2};
    LightPoint green = white;
    green.colour = kGreen;
    green.flash.startS = 2.5;
    return {white, green};
}

LightPoint obstacleLight(const glm::dvec3& place)
{
    LightPoint light;
    light.place = place;
    light.group = LightGroup::obstacle;
    light.beam = BeamKind::everywhere;
    light.candela = kObstacleCd;
    light.colour = kRed;
    return light;
}

} // namespace scenery
