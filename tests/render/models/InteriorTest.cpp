// SPDX-License-Identifier: Apache-2.0
// The inside of vehicles as it is drawn in the light of day, dusk and night.
#include <gtest/gtest.h>

#include <osgOffscreen/OffscreenContext>

#include "InteriorStudio.h"
#include "RenderedGolden.h"

namespace
{

using namespace scenery;
using models::EntityKind;
using models::Reading;
using models::Readings;
using seat::InteriorStudio;
using seat::kEyeOfAircraft;
using seat::kEyeOfCar;

constexpr int kWidePx = 640, kHighPx = 360; // from the seat

Readings someFlight()
{
    Readings readings;
    readings[Reading::airspeedKt] = 92.0;
    readings[Reading::pitchDeg] = 4.0;
    readings[Reading::rollDeg] = -15.0;
    readings[Reading::altitudeFt] = 3460.0;
    readings[Reading::altimeterHpa] = 1017.0;
    readings[Reading::turnDegps] = -3.0;
    readings[Reading::slip] = 0.4;
    readings[Reading::headingDeg] = 297.0;
    readings[Reading::climbFpm] = 430.0;
    readings[Reading::engineRpm] = 2350.0;
    readings[Reading::fuelLeft] = 0.6;
    readings[Reading::fuelRight] = 0.3;
    readings[Reading::flapDeg] = 10.0;
    readings[Reading::trim] = 0.25;
    readings[Reading::propellerRadps] = 246.0;
    return readings;
}

Readings someDrive()
{
    Readings readings;
    readings[Reading::speedKmh] = 83.0;
    readings[Reading::engineRpm] = 2650.0;
    readings[Reading::gear] = 4.0;
    readings[Reading::fuel] = 0.75;
    readings[Reading::steeringWheelDeg] = 38.0;
    readings[Reading::indicatorLeft] = 1.0;
    readings[Reading::headLamps] = 1.0;
    return readings;
}

/// Somebody's view who sits in a vehicle in the light of a sun.
class Seat
{
public:
    Seat(EntityKind kind, const glm::dvec3& eye, double sunDeg)
        : _eye(eye), _isDark(sunDeg < 2.0), _studio(kind, eye, kWidePx, kHighPx, airAt(sunDeg))
    {
    }

    osg::ref_ptr<osg::Image> picture(const Readings& readings)
    {
        _studio.interior.show({}, readings, _isDark);
        const double down = std::sin(0.12), level = std::cos(0.12);
        return _studio.picture({_eye, glm::dmat3({level, 0.0, -down}, {0.0, 1.0, 0.0}, {down, 0.0, level})},
                               55.0);
    }

private:
    static osgSky::AtmosphereSettings airAt(double sunDeg)
    {
        osgSky::AtmosphereSettings air;
        air.sunDirectionWorld = osgSky::sunDirectionFromAngles(120.0, sunDeg);
        return air;
    }

    glm::dvec3 _eye;
    bool _isDark;
    InteriorStudio _studio;
};

const std::string& rendererName()
{
    static const std::string kName = []
    {
        const auto context = osgOffscreen::OffscreenContext::create({.widthPx = 16, .heightPx = 16});
        return context ? (*context)->rendererName() : std::string();
    }();
    return kName;
}

TEST(Interior, LooksAsItDidByDayAtDuskAndAtNight)
{
    for (const auto& [name, sunDeg] : {std::pair{"day", 40.0}, {"dusk", 1.0}, {"night", -20.0}})
    {
        const auto cockpit = Seat(EntityKind::lightAircraft, kEyeOfAircraft, sunDeg).picture(someFlight());
        EXPECT_TRUE(rendered::matchesGolden(*cockpit, std::string("cockpit-") + name, rendererName()))
            << name;
        const auto car = Seat(EntityKind::car, kEyeOfCar, sunDeg).picture(someDrive());
        EXPECT_TRUE(rendered::matchesGolden(*car, std::string("car-interior-") + name, rendererName()))
            << name;
    }
}

/// The comparison can fail: each instrument alone, a little off, is seen.
TEST(Interior, AnInstrumentThatIsOffIsSeen)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    Seat pilot(EntityKind::lightAircraft, kEyeOfAircraft, -20.0), driver(EntityKind::car, kEyeOfCar, -20.0);
    for (const auto& [reading, off] : {std::pair{Reading::airspeedKt, 4.0},
                                       {Reading::pitchDeg, 2.0},
                                       {Reading::rollDeg, 3.0},
                                       {Reading::altitudeFt, 30.0},
                                       {Reading::altimeterHpa, 1.0},
                                       {Reading::turnDegps, 0.6},
                                       {Reading::slip, 0.3},
                                       {Reading::headingDeg, 3.0},
                                       {Reading::climbFpm, 60.0},
                                       {Reading::engineRpm, 60.0},
                                       {Reading::fuelLeft, 0.08},
                                       {Reading::fuelRight, 0.08},
                                       {Reading::flapDeg, 3.0},
                                       {Reading::trim, 0.15}})
    {
        Readings readings = someFlight();
        readings[reading] += off;
        const auto cockpit = pilot.picture(readings);
        EXPECT_FALSE(rendered::matchesGolden(*cockpit, "cockpit-night", rendererName()))
            << static_cast<int>(reading);
    }
    for (const auto& [reading, off] : {std::pair{Reading::speedKmh, 4.0},
                                       {Reading::engineRpm, 120.0},
                                       {Reading::gear, -1.0},
                                       {Reading::fuel, 0.1},
                                       {Reading::steeringWheelDeg, 4.0},
                                       {Reading::indicatorLeft, -1.0},
                                       {Reading::indicatorRight, 1.0},
                                       {Reading::headLamps, -1.0},
                                       {Reading::handbrake, 1.0}})
    {
        Readings readings = someDrive();
        readings[reading] += off;
        const auto car = driver.picture(readings);
        EXPECT_FALSE(rendered::matchesGolden(*car, "car-interior-night", rendererName()))
            << static_cast<int>(reading);
    }
}

} // namespace
