// SPDX-License-Identifier: Apache-2.0
// The figures of `trainer qualify light` that need no picture, and for each a fault that makes it fail.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "measurement/light/CloudFigures.h"
#include "measurement/light/FallFigures.h"
#include "measurement/light/LampFigures.h"
#include "measurement/light/SkyFigures.h"
#include "measurement/light/UnmeasuredGoals.h"

namespace
{

using namespace measurement;
using scenery::LightGroup;
using scenery::LightPoint;

/// The figure whose name begins so; one that fails where there is none.
LightFigure rowOf(const LightFigures& figures, const std::string& name)
{
    for (const LightFigure& figure : figures)
        if (figure.name.starts_with(name)) return figure;
    ADD_FAILURE() << "no figure " << name;
    return atMost("", name, std::nan(""), "", 0.0, "");
}

/// A row passes as things are, and a fault makes it fail.
void expectCaught(const LightFigures& sound, const LightFigures& faulty, const std::string& row)
{
    EXPECT_TRUE(rowOf(sound, row).passes()) << row << ": " << rowOf(sound, row).value;
    EXPECT_FALSE(rowOf(faulty, row).passes()) << row << ": " << rowOf(faulty, row).value;
}

struct LampFault
{
    const char* name;
    const char* row;
    std::function<void(LampParts&)> seed;
};

const std::vector<LampFault>& lampFaults()
{
    static const std::vector<LampFault> faults{
        {"lamps without Allard's law", "lamps: range",
         [](LampParts& parts) {
             parts.rangeM = [](double candela, double, double leastLx)
             { return std::sqrt(candela / leastLx); };
         }},
        {"fog 1.2 times as thick", "lamps: range",
         [](LampParts& parts)
         {
             parts.rangeM = [](double candela, double visibilityM, double leastLx)
             { return scenery::visibleRangeM(candela, visibilityM / 1.2, leastLx); };
         }},
        {"the steps of PAPI for all", "lamps: steps",
         [](LampParts& parts) {
             parts.shareOfStep = [](LightGroup, int step)
             { return scenery::shareOfStep(LightGroup::papi, step); };
         }},
        {"red and green exchanged", "position lamps: sectors",
         [](LampParts& parts) { std::swap(parts.position.left, parts.position.right); }},
        {"position lamps tilted", "position lamps: above",
         [](LampParts& parts) { parts.position.left.tiltDeg = 10.0; }},
        {"a position lamp turned", "position lamps: overlap",
         [](LampParts& parts) { parts.position.left.headingDeg = -15.0; }},
        {"a head lamp that glares", "dipped head lamp",
         [](LampParts& parts) { parts.lowBeam.tiltDeg = 1.0; }},
        {"PAPI mirrored", "PAPI: units",
         [](LampParts& parts)
         {
             parts.papi =
                 [](const glm::dvec2& threshold, const glm::dvec2& landing, double lengthM, double widthM)
             {
                 auto units = scenery::papiUnits(threshold, landing, lengthM, widthM);
                 for (scenery::PapiUnit& unit : units)
                     unit.place.y = -unit.place.y;
                 return units;
             };
         }},
        {"PAPI set wrong", "PAPI: settings",
         [](LampParts& parts)
         {
             parts.papi =
                 [](const glm::dvec2& threshold, const glm::dvec2& landing, double lengthM, double widthM)
             {
                 auto units = scenery::papiUnits(threshold, landing, lengthM, widthM);
                 units[1].angleDeg += 0.02;
                 return units;
             };
         }}};
    return faults;
}

struct SkyFault
{
    const char* name;
    const char* row;
    std::function<void(SkyParts&)> seed;
};

const std::vector<SkyFault>& skyFaults()
{
    using simulation::DateTime;
    static const std::vector<SkyFault> faults{
        {"the sun a minute late", "sun: direction",
         [](SkyParts& parts)
         {
             parts.sun = [](const DateTime& utc, double latitudeDeg, double longitudeDeg)
             { return simulation::sunDirection(utc.plusSeconds(-60.0), latitudeDeg, longitudeDeg); };
         }},
        {"the moon seen from the middle of the Earth", "moon: direction",
         [](SkyParts& parts)
         {
             parts.moon = [](const DateTime& utc, double latitudeDeg, double longitudeDeg)
             {
                 simulation::MoonSight moon = simulation::moonSight(utc, latitudeDeg, longitudeDeg);
                 constexpr double kEarthRadiusKm = 6378.14;
                 moon.towards =
                     glm::normalize(moon.towards * moon.distanceKm + glm::dvec3(0.0, 0.0, kEarthRadiusKm));
                 return moon;
             };
         }},
        {"the moon lit from the other side", "moon: phase",
         [](SkyParts& parts)
         {
             parts.moon = [](const DateTime& utc, double latitudeDeg, double longitudeDeg)
             {
                 simulation::MoonSight moon = simulation::moonSight(utc, latitudeDeg, longitudeDeg);
                 moon.litShare = 1.0 - moon.litShare;
                 return moon;
             };
         }},
        {"stars by another time zone", "stars: direction, worst of ten in 1999",
         [](SkyParts& parts)
         {
             parts.worldFromStars = [](const DateTime& utc, double latitudeDeg, double longitudeDeg)
             { return simulation::worldFromStars(utc.plusSeconds(3600.0), latitudeDeg, longitudeDeg); };
         }},
        {"stars that go out in jumps", "stars: faintest",
         [](SkyParts& parts)
         {
             parts.faintestSeen = [](double sunDeg, double)
             { return sunDeg < -12.0 ? 6.2 : (sunDeg < -6.0 ? 3.1 : 0.0); };
         }}};
    return faults;
}

/// Stars that come out evenly over the whole of a night, so that no minute has much of it.
SkyParts evenSky()
{
    SkyParts parts;
    parts.faintestSeen = [](double sunDeg, double) { return -0.1 * sunDeg; };
    return parts;
}

} // namespace

TEST(LightFaults, OfLampsAreCaught)
{
    const LightFigures sound = lampFigures();
    for (const LightFigure& figure : sound)
        EXPECT_TRUE(figure.passes()) << figure.name << ": " << figure.value;
    for (const LampFault& fault : lampFaults())
    {
        LampParts parts;
        fault.seed(parts);
        SCOPED_TRACE(fault.name);
        expectCaught(sound, lampFigures(parts), fault.row);
    }
}

TEST(LightFaults, OfTheSkyAreCaught)
{
    const LightFigures sound = skyFigures(evenSky());
    for (const SkyFault& fault : skyFaults())
    {
        SkyParts parts = evenSky();
        fault.seed(parts);
        SCOPED_TRACE(fault.name);
        expectCaught(sound, skyFigures(parts), fault.row);
    }
}

// The sun is drawn without refraction, so that figure is missed; with it, it would be reached.
TEST(LightFaults, ARefractedSunWouldRiseInTime)
{
    const char* const kRow = "sun: rise and set";
    EXPECT_FALSE(rowOf(skyFigures(), kRow).passes());
    SkyParts parts;
    parts.sun = [](const simulation::DateTime& utc, double latitudeDeg, double longitudeDeg)
    {
        simulation::SunDirection sun = simulation::sunDirection(utc, latitudeDeg, longitudeDeg);
        sun.elevationDeg += 34.0 / 60.0;
        return sun;
    };
    EXPECT_TRUE(rowOf(skyFigures(parts), kRow).passes()) << rowOf(skyFigures(parts), kRow).value;
}

TEST(LightFaults, OfCloudsAreCaught)
{
    using scenery::clouds::CloudVolume;
    using simulation::CloudLayer;
    std::map<int, CloudVolume> made; // by oktas
    CloudParts parts;
    parts.kinds = {simulation::CloudKind::cumulus};
    parts.make = [&](const CloudLayer& layer, std::uint32_t seed)
    {
        if (!made.contains(layer.oktas)) made[layer.oktas] = scenery::clouds::makeCloudVolume(layer, seed);
        return made[layer.oktas];
    };
    const LightFigures sound = cloudFigures(parts);
    CloudParts more = parts, higher = parts;
    more.make = [&](CloudLayer layer, std::uint32_t seed)
    {
        layer.oktas = std::min(layer.oktas + 1, 8);
        return parts.make(layer, seed);
    };
    higher.make = [&](const CloudLayer& layer, std::uint32_t seed)
    {
        CloudVolume volume = parts.make(layer, seed);
        volume.baseM += 60.0;
        volume.topM += 60.0;
        return volume;
    };
    expectCaught(sound, cloudFigures(more), "cumulus: cover");
    expectCaught(sound, cloudFigures(higher), "cumulus: base");
}

TEST(LightFaults, OfWhatFallsAreCaught)
{
    const LightFigures sound = fallFigures();
    FallParts parts;
    parts.visibilityM = [](double clearM, const simulation::Hydrometeors&) { return clearM; };
    parts.wetness = [](double waterMm) { return waterMm < 1.0 ? waterMm : 2.0 - waterMm; };
    const LightFigures faulty = fallFigures(parts);
    for (const char* row : {"rain to 100", "snow to 10", "water to 2"})
        expectCaught(sound, faulty, row);
}

TEST(LightFaults, AFigureWithoutANumberFails)
{
    EXPECT_FALSE(atMost("N1", "none", std::nan(""), "", 1.0, "").passes());
    LightFigure figure = atMost("N1", "some", 0.5, "", 1.0, "");
    EXPECT_TRUE(figure.passes());
    figure.least = 0.6;
    EXPECT_FALSE(figure.passes());
}

TEST(LightFaults, WhatIsNotMeasuredSaysWhy)
{
    EXPECT_FALSE(unmeasuredGoals().empty());
    for (const auto& [goal, what, why] : unmeasuredGoals())
    {
        EXPECT_EQ(goal[0], 'N');
        EXPECT_GT(std::string(why).size(), 10U) << what;
    }
}
