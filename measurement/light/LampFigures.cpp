// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/LampFigures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/glm.hpp>
#include <glm/trigonometric.hpp>

namespace measurement
{

using scenery::BeamKind;
using scenery::LightGroup;
using scenery::LightPoint;

namespace
{

/// Ranges worked out from Allard's law by another program, to three digits.
const std::vector<KnownRange>& knownRanges()
{
    static const std::vector<KnownRange> known{
        {1000, 8e-7, 0.4, 0.96},  {1000, 8e-7, 1.5, 2.61},  {1000, 8e-7, 5, 5.95},
        {1000, 8e-7, 10, 9.08},   {1000, 8e-7, 50, 19.6},   {1000, 1e-4, 0.4, 0.50},
        {1000, 1e-4, 1.5, 1.08},  {1000, 1e-4, 5, 1.83},    {1000, 1e-4, 10, 2.26},
        {1000, 1e-4, 50, 2.90},   {2500, 8e-7, 0.4, 1.06},  {2500, 8e-7, 50, 25.8},
        {10000, 8e-7, 0.4, 1.21}, {10000, 8e-7, 1.5, 3.48}, {10000, 8e-7, 5, 8.57},
        {10000, 8e-7, 10, 13.9},  {10000, 8e-7, 50, 37.0},  {10000, 1e-4, 5, 3.50},
        {10000, 1e-4, 50, 7.89},  {10000, 1e-5, 0.4, 0.94}, {10000, 1e-5, 10, 8.65},
        {10000, 1e-5, 50, 18.3},  {20000, 8e-7, 10, 15.5},  {20000, 8e-7, 50, 43.3},
        {20000, 1e-4, 1.5, 1.97}, {20000, 1e-4, 50, 10.4},  {10000, 1e-3, 1.5, 1.08},
        {10000, 1e-3, 50, 2.90}};
    return known;
}

LightPoint positionLamp(BeamKind kind)
{
    LightPoint lamp;
    lamp.candela = kind == BeamKind::rear ? 20.0 : 40.0;
    lamp.headingDeg = kind == BeamKind::rear ? 180.0 : 0.0;
    lamp.beam = kind;
    return lamp;
}

double towards(const LampParts& parts, const LightPoint& lamp, double asideDeg, double upDeg)
{
    const double a = glm::radians(asideDeg), u = glm::radians(upDeg);
    const glm::dvec3 along(std::cos(u) * std::cos(a), std::cos(u) * std::sin(a), std::sin(u));
    return parts.candelaTowards(lamp, lamp.place + 100.0 * along, 0.0);
}

double worstStep(const LampParts& parts)
{
    constexpr std::array<double, 5> kHigh{0.002, 0.01, 0.05, 0.25, 1.0}; // steps 1 to 5
    constexpr std::array<double, 3> kOthers{0.1, 0.3, 1.0};              // steps 3 to 5
    const auto off = [&](LightGroup group, int step, double share)
    { return std::abs(parts.shareOfStep(group, step) / share - 1.0); };
    double worst = 0.0;
    for (const LightGroup group :
         {LightGroup::runway, LightGroup::approach, LightGroup::centreLine, LightGroup::touchdownZone})
        for (int step = 1; step <= 5; ++step)
            worst = std::max(worst, off(group, step, kHigh[static_cast<std::size_t>(step - 1)]));
    for (const LightGroup group : {LightGroup::papi, LightGroup::taxiway})
        for (int step = 3; step <= 5; ++step)
            worst = std::max(worst, off(group, step, kOthers[static_cast<std::size_t>(step - 3)]));
    return worst;
}

/// How far the lamps are from the sectors of 14 CFR 23.1391, as a share.
double worstSector(const LampParts& parts)
{
    struct Sector
    {
        double fromDeg, toDeg, candela;
    };
    constexpr std::array kAhead{Sector{0, 10, 40}, Sector{10, 20, 30}, Sector{20, 110, 5}};
    double worst = 0.0;
    const auto look = [&](const LightPoint& lamp, double deg, double candela)
    { worst = std::max(worst, std::abs(towards(parts, lamp, deg, 0.0) / candela - 1.0)); };
    for (const Sector& sector : kAhead)
        for (double deg = sector.fromDeg + 0.5; deg < sector.toDeg; deg += 0.5)
        {
            look(parts.position.left, deg, sector.candela);
            look(parts.position.right, -deg, sector.candela);
        }
    for (double deg = 111.0; deg < 249.0; deg += 1.0)
        look(parts.position.rear, deg, 20.0);
    return worst;
}

/// How far intensities above and below are from the factors of 14 CFR 23.1393, as a share.
double worstFactor(const LampParts& parts)
{
    struct Band
    {
        double deg, share;
    };
    double worst = 0.0;
    for (const Band& band : {Band{0, 1}, {2, .9}, {7, .8}, {12, .7}, {17, .5}, {25, .3}, {35, .1}, {60, .05}})
        for (const double side : {-1.0, 1.0})
        {
            const double candela = towards(parts, parts.position.left, 5.0, side * band.deg);
            worst = std::max(worst, std::abs(candela / (40.0 * band.share) - 1.0));
        }
    return worst;
}

/// The most that shines into a neighbour's sector, over what 14 CFR 23.1395 allows there.
double worstOverlap(const LampParts& parts)
{
    double worst = 0.0;
    const auto look = [&](const LightPoint& lamp, double firstDeg, double lastDeg)
    {
        for (double beyond = 10.5; beyond < 60.0; beyond += 0.5)
        {
            const double most = beyond < 20.0 ? 10.0 : 1.0;
            for (const double deg : {firstDeg - beyond, lastDeg + beyond})
                worst = std::max(worst, towards(parts, lamp, deg, 0.0) / most);
        }
    };
    look(parts.position.left, 0.0, 110.0);
    look(parts.position.right, -110.0, 0.0);
    look(parts.position.rear, 110.0, 250.0);
    return worst;
}

/// How far a dipped head lamp is beyond the limits of UN R112 at the worst of eight points, as a share.
double worstLowBeam(const LampParts& parts)
{
    struct Point
    {
        double leftDeg, upDeg, least, most; // candela
    };
    constexpr double kAny = 1e9;
    constexpr Point kB50L{3.43, 0.57, 0, 350}, k75R{-1.15, -0.57, 10100, kAny}, k75L{3.43, -0.57, 0, 10600},
        k50L{3.43, -0.86, 0, 13200}, k50R{-1.72, -0.86, 10100, kAny}, k50V{0, -0.86, 5100, kAny},
        k25L{9.0, -1.72, 1700, kAny}, k25R{-9.0, -1.72, 1700, kAny};
    double worst = 0.0;
    for (const Point& point : {kB50L, k75R, k75L, k50L, k50R, k50V, k25L, k25R})
    {
        const double candela = towards(parts, parts.lowBeam, point.leftDeg, point.upDeg);
        if (point.least > 0.0) worst = std::max(worst, 1.0 - candela / point.least);
        worst = std::max(worst, candela / point.most - 1.0);
    }
    return worst;
}

/// How many of the four units do not stand where they have to: left of the runway, the steepest nearest to
/// it.
int displacedUnits(std::span<const scenery::PapiUnit> units)
{
    int wrong =
        static_cast<int>(std::max<std::size_t>(units.size(), 4) - std::min<std::size_t>(units.size(), 4));
    double before = 0.0, steeper = 90.0;
    for (const scenery::PapiUnit& unit : units) // the runway lies along x
    {
        const bool isInPlace = unit.place.y > before && unit.angleDeg < steeper && unit.towards.x < 0.0;
        wrong += isInPlace ? 0 : 1;
        before = unit.place.y;
        steeper = unit.angleDeg;
    }
    return wrong;
}

/// The largest deviation of a unit's setting, minutes of arc; without four units it is no number.
double worstSetting(std::span<const scenery::PapiUnit> units)
{
    constexpr std::array<double, 4> kMinutes{210.0, 190.0, 170.0, 150.0};
    if (units.size() != kMinutes.size()) return std::nan("");
    double worst = 0.0;
    for (std::size_t i = 0; i < kMinutes.size(); ++i)
        worst = std::max(worst, std::abs(60.0 * units[i].angleDeg - kMinutes[i]));
    return worst;
}

} // namespace

LightPoint defaultLowBeam()
{
    LightPoint lamp;
    lamp.candela = 13000.0;
    lamp.beam = BeamKind::lowBeam;
    return lamp;
}

PositionLamps defaultPositionLamps()
{
    return {positionLamp(BeamKind::forwardLeft), positionLamp(BeamKind::forwardRight),
            positionLamp(BeamKind::rear)};
}

double worstRange(const LampRange& rangeM)
{
    double worst = 0.0;
    for (const KnownRange& known : knownRanges())
    {
        const double seenM = rangeM(known.candela, 1000.0 * known.visibilityKm, known.leastLx);
        worst = std::max(worst, std::abs(seenM / (1000.0 * known.rangeKm) - 1.0));
    }
    return worst;
}

LightFigures lampFigures(const LampParts& parts)
{
    const auto units = parts.papi({0.0, 0.0}, {1.0, 0.0}, 1500.0, 30.0);
    return {
        atMost("N4", "lamps: range, worst of 28", kPercent * worstRange(parts.rangeM), "%", 3.0,
               "Allard 1876; thresholds of ICAO Annex 3, attachment D"),
        atMost("N4", "lamps: steps", kPercent * worstStep(parts), "%", 2.0, "ICAO Doc 9157, part 4"),
        atMost("N4", "position lamps: sectors", kPercent * worstSector(parts), "%", 5.0, "14 CFR 23.1391"),
        atMost("N4", "position lamps: above and below", kPercent * worstFactor(parts), "%", 5.0,
               "14 CFR 23.1393"),
        atMost("N4", "position lamps: overlap over its limit", worstOverlap(parts), "", 1.0,
               "14 CFR 23.1395"),
        atMost("N6", "dipped head lamp from afar: beyond its limits, worst of 8 points",
               kPercent * worstLowBeam(parts), "%", 10.0, "UN R112, class B"),
        atMost("N4", "PAPI: units out of place", displacedUnits(units), "", 0.0, "ICAO Annex 14, 5.3.5"),
        atMost("N4", "PAPI: settings", worstSetting(units), "'", 0.5, "ICAO Annex 14, 5.3.5"),
    };
}

} // namespace measurement
