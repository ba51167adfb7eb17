// SPDX-License-Identifier: Apache-2.0
// Where the hands of every instrument stand, against places reckoned by hand: five values, both limits,
// beyond them, and no number.
#include "scenery/models/cockpit/Dial.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "scenery/models/ModelCheck.h"
#include "scenery/models/cockpit/InstrumentParts.h"
#include "scenery/models/cockpit/InteriorModel.h"
#include "scenery/models/entities/DefaultSize.h"

namespace
{

using namespace scenery::models;

/// Values of a hand and its angles from the top, clockwise. The first and the last are its limits.
struct Expected
{
    Instrument instrument;
    std::size_t hand;
    std::vector<DialPoint> places;
};

const std::vector<Expected>& expected()
{
    static const std::vector<Expected> kAll{
        {Instrument::airspeed,
         0,
         {{0, 0}, {20, 15}, {40, 30}, {70, 102.5}, {100, 175}, {130, 247.5}, {160, 320}}},
        {Instrument::altimeter,
         0,
         {{0, 0}, {250, 90}, {500, 180}, {1000, 0}, {1750, 270}, {-250, 270}, {9999, 359.64}}},
        {Instrument::altimeter, 1, {{0, 0}, {2500, 90}, {5000, 180}, {7500, 270}, {10000, 0}}},
        {Instrument::altimeter, 2, {{0, 0}, {2500, 9}, {25000, 90}, {50000, 180}, {75000, 270}}},
        {Instrument::turn, 0, {{-6, -40}, {-3, -20}, {-1.5, -10}, {0, 0}, {1.5, 10}, {3, 20}, {6, 40}}},
        {Instrument::turn, 1, {{-1, -16}, {-0.5, -8}, {0, 0}, {0.25, 4}, {0.5, 8}, {1, 16}}},
        {Instrument::heading, 0, {{0, 0}, {45, -45}, {90, -90}, {180, -180}, {270, -270}, {359, -359}}},
        {Instrument::climb,
         0,
         {{-2000, 98}, {-1000, 184}, {-500, 227}, {0, 270}, {500, 313}, {1000, 356}, {2000, 82}}},
        {Instrument::tachometer,
         0,
         {{0, -125}, {700, -75}, {1400, -25}, {2100, 25}, {2800, 75}, {3500, 125}}},
        {Instrument::fuelLeft, 0, {{0, -60}, {0.25, -30}, {0.5, 0}, {0.75, 30}, {1, 60}}},
        {Instrument::fuelRight, 0, {{0, -60}, {0.1, -48}, {0.5, 0}, {0.9, 48}, {1, 60}}},
        {Instrument::flaps, 0, {{0, -60}, {10, -20}, {15, 0}, {20, 20}, {30, 60}}},
        {Instrument::trim, 0, {{-1, -60}, {-0.5, -30}, {0, 0}, {0.5, 30}, {1, 60}}},
        {Instrument::speedometer, 0, {{0, -130}, {60, -65}, {120, 0}, {150, 32.5}, {180, 65}, {240, 130}}},
        {Instrument::revs, 0, {{0, -130}, {2000, -65}, {4000, 0}, {6000, 65}, {8000, 130}}},
        {Instrument::fuel, 0, {{0, -60}, {0.25, -30}, {0.5, 0}, {0.75, 30}, {1, 60}}}};
    return kAll;
}

bool isAt(double angleDeg, double expectedDeg)
{
    return std::abs(std::remainder(angleDeg - expectedDeg, 360.0)) < 1e-9;
}

bool standsWhereExpected(const DialHand& hand, const Expected& of)
{
    for (const DialPoint& place : of.places)
        if (!isAt(handAngleDeg(hand, place.value), place.angleDeg)) return false;
    return true;
}

TEST(Dials, HandsStandWhereTheScaleHasTheValue)
{
    std::set<std::pair<Instrument, std::size_t>> tested;
    for (const Expected& of : expected())
    {
        const DialHand& hand = dialOf(of.instrument).hands.at(of.hand);
        for (const DialPoint& place : of.places)
            EXPECT_TRUE(isAt(handAngleDeg(hand, place.value), place.angleDeg))
                << dialOf(of.instrument).label << " at " << place.value << ": "
                << handAngleDeg(hand, place.value);
        tested.insert({of.instrument, of.hand});
    }
    for (int i = 0; i < static_cast<int>(Instrument::dials); ++i)
        for (std::size_t hand = 0; hand < dialOf(static_cast<Instrument>(i)).hands.size(); ++hand)
            EXPECT_TRUE(tested.contains({static_cast<Instrument>(i), hand})) << "instrument " << i;
}

TEST(Dials, StayAtTheEndsOfTheirScales)
{
    for (const Expected& of : expected())
    {
        const DialHand& hand = dialOf(of.instrument).hands.at(of.hand);
        EXPECT_EQ(handAngleDeg(hand, std::nan("")), hand.scale.front().angleDeg);
        EXPECT_EQ(handAngleDeg(hand, std::numeric_limits<double>::infinity()), hand.scale.front().angleDeg);
        if (hand.motion == DialMotion::round) continue;
        EXPECT_TRUE(isAt(handAngleDeg(hand, of.places.front().value - 1e6), of.places.front().angleDeg));
        EXPECT_TRUE(isAt(handAngleDeg(hand, of.places.back().value + 1e6), of.places.back().angleDeg));
    }
}

/// The control: a scale whose middle or end is wrong by a degree is found, on every instrument.
TEST(Dials, AWrongScaleIsFound)
{
    for (const Expected& of : expected())
    {
        DialHand hand = dialOf(of.instrument).hands.at(of.hand);
        ASSERT_TRUE(standsWhereExpected(hand, of));
        hand.scale.back().angleDeg += 1.0;
        EXPECT_FALSE(standsWhereExpected(hand, of)) << dialOf(of.instrument).label;
    }
}

/// Where a point of the ball's front comes to lie, in shares of its radius.
glm::dvec3 onBall(double pitchDeg, double rollDeg, const glm::dvec3& at)
{
    return glm::dvec3(attitudeTurn(pitchDeg, rollDeg) * glm::dvec4(at, 1.0));
}

TEST(Attitude, TheHorizonFallsAsTheNoseRisesAndTurnsAgainstTheRoll)
{
    const double toRad = 3.14159265358979 / 180.0;
    for (const double pitch : {-60.0, -20.0, 0.0, 5.0, 30.0, 89.0})
        for (const double roll : {-170.0, -45.0, 0.0, 10.0, 60.0, 180.0})
        {
            // The horizon's middle is below the middle by the sine of the pitch, turned with the horizon.
            const glm::dvec3 middle = onBall(pitch, roll, {0.0, 0.0, 1.0});
            EXPECT_NEAR(middle.x, std::sin(pitch * toRad) * std::sin(roll * toRad), 1e-12);
            EXPECT_NEAR(middle.y, -std::sin(pitch * toRad) * std::cos(roll * toRad), 1e-12);
            // To the right along the horizon: up by the roll, as its right wing is down.
            const glm::dvec3 right = onBall(pitch, roll, {1.0, 0.0, 0.0});
            EXPECT_NEAR(right.x, std::cos(roll * toRad), 1e-12);
            EXPECT_NEAR(right.y, std::sin(roll * toRad), 1e-12);
        }
    EXPECT_EQ(onBall(std::nan(""), std::nan(""), {0.0, 0.0, 1.0}), glm::dvec3(0.0, 0.0, 1.0));
}

InteriorModel interiorOf(EntityKind kind)
{
    EntityShape shape;
    shape.kind = kind;
    setDefaultSize(shape);
    return *makeInterior(shape, {1.0, 0.3, 1.5});
}

const InteriorPart& partOf(const InteriorModel& interior, const std::string& name)
{
    for (const InteriorPart& part : interior.parts)
        if (part.name == name) return part;
    throw std::out_of_range(name);
}

TEST(Interior, IsMadeOfSoundPartsForWhateverOneSitsIn)
{
    for (const EntityKind kind :
         {EntityKind::car, EntityKind::van, EntityKind::bus, EntityKind::lorry, EntityKind::tractor,
          EntityKind::lightAircraft, EntityKind::glider, EntityKind::airliner, EntityKind::helicopter})
        for (const InteriorPart& part : interiorOf(kind).parts)
            EXPECT_EQ(defectOf(part.model), "") << part.name;
    for (const EntityKind kind :
         {EntityKind::bicycle, EntityKind::pedestrian, EntityKind::ship, EntityKind::box})
    {
        EntityShape shape;
        shape.kind = kind;
        EXPECT_FALSE(makeInterior(shape, {}));
    }
}

/// Which figure of a drum looks at the eye: by the direction that its matrix turns to the eye.
int figureOf(const InteriorPart& drum, const Readings& readings)
{
    for (int figure = 0; figure < kDrumFigures; ++figure)
    {
        const double up = 2.0 * 3.14159265358979 * figure / kDrumFigures;
        const glm::dvec4 turned = drum.place(readings) * glm::dvec4(0.0, std::sin(up), std::cos(up), 0.0);
        if (turned.x < -0.999) return figure; // the eye is behind, along -x
    }
    return -1;
}

TEST(Interior, DrumsShowTheirNumbers)
{
    Readings readings;
    const InteriorModel cockpit = interiorOf(EntityKind::lightAircraft), car = interiorOf(EntityKind::car);
    for (const double hpa : {945.0, 1000.0, 1013.25, 1029.6, 1050.0})
    {
        readings[Reading::altimeterHpa] = hpa;
        int shown = 0;
        for (const InteriorPart& part : cockpit.parts)
            if (part.name == "altimeter setting drum") shown = 10 * shown + figureOf(part, readings);
        EXPECT_EQ(shown, std::lround(hpa));
    }
    for (const int gear : {-1, 0, 1, 3, 6})
    {
        readings[Reading::gear] = gear;
        EXPECT_EQ(figureOf(partOf(car, "gear drum"), readings), gear + 1);
    }
}

TEST(Interior, TheSteeringWheelTurnsWithTheReading)
{
    const InteriorModel car = interiorOf(EntityKind::car);
    const InteriorPart& wheel = partOf(car, "steering wheel");
    Readings readings;
    for (const double degrees : {-360.0, -90.0, 0.0, 45.0, 90.0, 450.0})
    {
        readings[Reading::steeringWheelDeg] = degrees;
        // Its left spoke goes down as it is turned to the left.
        const glm::dvec4 spoke = wheel.place(readings) * glm::dvec4(-1.0, 0.0, 0.0, 0.0);
        EXPECT_NEAR(spoke.y, std::cos(degrees * 3.14159265358979 / 180.0), 1e-9);
        EXPECT_LE(spoke.z * std::sin(degrees * 3.14159265358979 / 180.0), 1e-9);
    }
}

TEST(Interior, TelltalesAreSeenWhileTheirLampsShine)
{
    const InteriorModel car = interiorOf(EntityKind::car);
    for (const auto& [name, reading] : {std::pair{"indicator left", Reading::indicatorLeft},
                                        {"indicator right", Reading::indicatorRight},
                                        {"head lamps", Reading::headLamps},
                                        {"handbrake", Reading::handbrake}})
    {
        Readings readings;
        EXPECT_FALSE(partOf(car, name).isShown(readings));
        readings[reading] = 1.0;
        EXPECT_TRUE(partOf(car, name).isShown(readings)) << name;
    }
}

} // namespace
