// SPDX-License-Identifier: Apache-2.0
// The instruments of an aircraft in the arrangement of 14 CFR 23.1321 (airspeed, attitude, altitude above,
// heading below), the marks of the airspeed indicator by 14 CFR 23.1545 with the speeds of the Cessna 172P's
// handbook; and those of a car.
#include "scenery/models/cockpit/Panel.h"

#include <array>

namespace scenery::models
{

namespace
{

using Shape = DialHand::Shape;

const glm::vec3 kGreen(0.15F, 0.65F, 0.20F), kYellow(0.90F, 0.75F, 0.10F), kNeedleRed(0.80F, 0.10F, 0.10F),
    kWhite(0.92F, 0.92F, 0.90F);

DialHand hand(Reading reading, std::vector<DialPoint> scale)
{
    return {reading, std::move(scale)};
}

DialHand roundHand(Reading reading, double period, double reach, double width)
{
    return {reading, {{0.0, 0.0}, {period, 360.0}}, DialMotion::round, Shape::needle, reach, width};
}

/// A small gauge over half a circle.
Dial smallGauge(std::string_view label, Reading reading, double least, double most, double step,
                std::string_view ends)
{
    Dial dial{label, {hand(reading, {{least, -60.0}, {most, 60.0}})}, step, step, 0.0};
    dial.ends = ends;
    return dial;
}

Dial altimeter()
{
    Dial dial{"ALT",
              {roundHand(Reading::altitudeFt, 1000.0, 0.80, 0.06),
               roundHand(Reading::altitudeFt, 10'000.0, 0.52, 0.11),
               roundHand(Reading::altitudeFt, 100'000.0, 0.30, 0.08)},
              20.0,
              100.0,
              100.0,
              100.0};
    return dial;
}

Dial turnCoordinator()
{
    Dial dial{"TURN", {}, 3.0, 3.0, 0.0};
    dial.hands = {
        {Reading::turnDegps, {{-6.0, -40.0}, {6.0, 40.0}}, DialMotion::scale, Shape::aeroplane, 0.72},
        {Reading::slip, {{-1.0, -16.0}, {1.0, 16.0}}, DialMotion::scale, Shape::ball, 0.62, 0.16}};
    return dial;
}

Dial headingIndicator()
{
    Dial dial{"", {}, 5.0, 10.0, 30.0, 10.0};
    dial.hands = {{Reading::headingDeg, {{0.0, 0.0}, {360.0, -360.0}}, DialMotion::round, Shape::card}};
    return dial;
}

std::array<Dial, static_cast<std::size_t>(Instrument::dials)> makeDials()
{
    return {Dial{"KT",
                 {hand(Reading::airspeedKt, {{0.0, 0.0}, {40.0, 30.0}, {160.0, 320.0}})},
                 5.0,
                 10.0,
                 20.0,
                 1.0,
                 {{33.0, 85.0, kWhite},
                  {44.0, 127.0, kGreen},
                  {127.0, 158.0, kYellow},
                  {157.0, 159.0, kNeedleRed}}},
            altimeter(),
            turnCoordinator(),
            headingIndicator(),
            Dial{"FT/MIN",
                 {hand(Reading::climbFpm, {{-2000.0, -262.0}, {2000.0, 82.0}})},
                 100.0,
                 500.0,
                 500.0,
                 100.0},
            Dial{"RPM",
                 {hand(Reading::engineRpm, {{0.0, -125.0}, {3500.0, 125.0}})},
                 100.0,
                 500.0,
                 500.0,
                 100.0,
                 {{2100.0, 2700.0, kGreen}, {2690.0, 2720.0, kNeedleRed}}},
            smallGauge("LEFT", Reading::fuelLeft, 0.0, 1.0, 0.25, "EF"),
            smallGauge("RIGHT", Reading::fuelRight, 0.0, 1.0, 0.25, "EF"),
            smallGauge("FLAPS", Reading::flapDeg, 0.0, 30.0, 10.0, "03"),
            smallGauge("TRIM", Reading::trim, -1.0, 1.0, 0.5, "DU"),
            Dial{"KM/H", {hand(Reading::speedKmh, {{0.0, -130.0}, {240.0, 130.0}})}, 5.0, 10.0, 40.0},
            Dial{"X1000",
                 {hand(Reading::engineRpm, {{0.0, -130.0}, {8000.0, 130.0}})},
                 250.0,
                 1000.0,
                 1000.0,
                 1000.0,
                 {{6300.0, 8000.0, kNeedleRed}}},
            smallGauge("FUEL", Reading::fuel, 0.0, 1.0, 0.25, "EF")};
}

} // namespace

const Dial& dialOf(Instrument instrument)
{
    static const auto kDials = makeDials();
    return kDials[static_cast<std::size_t>(instrument)];
}

std::span<const PlacedInstrument> aircraftPanel()
{
    static constexpr std::array kPanel{PlacedInstrument{Instrument::airspeed, {-0.095, -0.175}, 0.042},
                                       PlacedInstrument{Instrument::attitude, {0.0, -0.175}, 0.042},
                                       PlacedInstrument{Instrument::altimeter, {0.095, -0.175}, 0.042},
                                       PlacedInstrument{Instrument::turn, {-0.095, -0.285}, 0.042},
                                       PlacedInstrument{Instrument::heading, {0.0, -0.285}, 0.042},
                                       PlacedInstrument{Instrument::climb, {0.095, -0.285}, 0.042},
                                       PlacedInstrument{Instrument::tachometer, {0.205, -0.185}, 0.042},
                                       PlacedInstrument{Instrument::fuelLeft, {0.183, -0.275}, 0.024},
                                       PlacedInstrument{Instrument::fuelRight, {0.237, -0.275}, 0.024},
                                       PlacedInstrument{Instrument::flaps, {0.295, -0.275}, 0.024},
                                       PlacedInstrument{Instrument::trim, {0.295, -0.205}, 0.024}};
    return kPanel;
}

std::span<const PlacedInstrument> carPanel()
{
    static constexpr std::array kPanel{PlacedInstrument{Instrument::revs, {-0.095, -0.325}, 0.055},
                                       PlacedInstrument{Instrument::speedometer, {0.095, -0.325}, 0.055},
                                       PlacedInstrument{Instrument::fuel, {0.0, -0.302}, 0.025}};
    return kPanel;
}

} // namespace scenery::models
