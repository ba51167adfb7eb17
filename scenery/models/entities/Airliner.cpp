// SPDX-License-Identifier: Apache-2.0
// A twin-jet airliner of the single-aisle class: 37.6 m long, 35.8 m span, 11.8 m high. Origin: on the ground
// below the main wheels.
#include "scenery/models/entities/Airframe.h"
#include "scenery/models/entities/EntityGenerators.h"

namespace scenery::models
{

namespace
{

constexpr double kAirlinerLengthM = 37.6, kAirlinerAxisZM = 3.9;
constexpr int kAirlinerSides = 40;

void addAirlinerFuselage(ModelBuilder& body, const glm::vec3& trim)
{
    const auto rings = fuselageRings({{-19.4, kAirlinerAxisZM + 1.25, 0.15, 0.25},
                                      {-17.5, kAirlinerAxisZM + 1.05, 0.60, 0.75},
                                      {-13.5, kAirlinerAxisZM + 0.55, 1.35, 1.50},
                                      {-9.5, kAirlinerAxisZM + 0.12, 1.85, 1.93},
                                      {-7.0, kAirlinerAxisZM, 1.975, 2.05},
                                      {10.5, kAirlinerAxisZM, 1.975, 2.05},
                                      {13.2, kAirlinerAxisZM, 1.97, 2.03},
                                      {14.7, kAirlinerAxisZM - 0.08, 1.86, 1.92},
                                      {15.5, kAirlinerAxisZM - 0.18, 1.70, 1.72},
                                      {16.6, kAirlinerAxisZM - 0.42, 1.35, 1.28},
                                      {17.5, kAirlinerAxisZM - 0.65, 0.85, 0.75},
                                      {18.1, kAirlinerAxisZM - 0.78, 0.28, 0.25}},
                                     2.1);
    body.begin("fuselage", kAircraftPaint, kAircraftWhite);
    addLoft(body, rings, kAirlinerSides);
    body.begin("stripe", kAircraftPaint, trim);
    for (const auto& [from, to] : {std::pair{38, 40}, {20, 22}})
        addBand(body, rings, kAirlinerSides, {2, 9, from, to, 0.012});
    body.begin("windows", kAircraftPaint, kCanopy);
    addBand(body, rings, kAirlinerSides, {9, 10, 5, 15, 0.015}); // the cockpit's
    for (const double side : {1.0, -1.0})
        for (int i = 0; i < 34; ++i)
        {
            const double x = -8.5 + 0.62 * i;
            box(body, {x, side * 1.955 - 0.03, kAirlinerAxisZM + 0.45},
                {x + 0.26, side * 1.955 + 0.03, kAirlinerAxisZM + 0.80});
        }
}

void addWingsOf(Airframe& frame, const glm::vec3& trim)
{
    const AerofoilStation root{{4.2, 0.0, 2.75}, 7.4, 0.13}, side{{3.1, 1.9, 2.85}, 6.6, 0.13},
        kink{{0.4, 6.2, 3.2}, 3.9}, outer{{-3.4, 12.5, 3.85}, 2.5, 0.11}, tip{{-6.0, 16.9, 4.3}, 1.6, 0.10};
    Airframe::Wing flapped;
    flapped.stations = {root, side, kink, outer};
    flapped.hingeShare = 0.76;
    flapped.hingedFrom = 2;
    flapped.hingedTo = 3;
    flapped.left = AircraftJoint::leftFlap;
    flapped.right = AircraftJoint::rightFlap;
    frame.addWings(flapped);
    Airframe::Wing banking;
    banking.stations = {outer, tip};
    banking.hingeShare = 0.74;
    banking.left = AircraftJoint::leftAileron;
    banking.right = AircraftJoint::rightAileron;
    frame.addWings(banking);
    Airframe::Wing tail;
    tail.stations = {{{-14.2, 0.2, kAirlinerAxisZM + 1.1}, 4.0, 0.10},
                     {{-17.3, 6.2, kAirlinerAxisZM + 1.7}, 1.5, 0.10}};
    tail.hingeShare = 0.70;
    frame.addWings(tail);
    Airframe::Wing fin;
    fin.tint = trim;
    fin.stations = {{{-11.6, 0.0, kAirlinerAxisZM + 1.7}, 6.6, 0.09},
                    {{-13.4, 0.0, kAirlinerAxisZM + 3.0}, 5.1, 0.09},
                    {{-17.0, 0.0, 11.4}, 2.3, 0.09},
                    {{-17.4, 0.0, 11.75}, 1.7, 0.07}};
    fin.hingeShare = 0.70;
    fin.hingedFrom = 1;
    fin.hingedTo = 2;
    frame.addWing(fin, AircraftJoint::rudder);
}

void addEngines(ModelBuilder& body, const glm::vec3& trim)
{
    for (const double side : {1.0, -1.0})
    {
        const auto ring = [&](double x, double radius) {
            return LoftRing{{x, side * 5.75, 1.75}, {0.0, radius, 0.0}, {0.0, 0.0, radius}};
        };
        body.begin("nacelles", kAircraftPaint, trim);
        addLoft(body,
                {ring(-1.2, 0.0), ring(-1.2, 0.55), ring(-0.4, 0.90), ring(1.6, 1.12), ring(3.2, 1.10),
                 ring(3.5, 1.0), ring(3.5, 0.88), ring(3.0, 0.84), ring(3.0, 0.0)},
                28);
        body.begin("fans", kPlain, kAircraftTyre);
        addLoft(body, {ring(2.98, 0.0), ring(2.98, 0.86), ring(3.04, 0.86), ring(3.3, 0.0)}, 28);
        body.begin("pylons", kAircraftPaint, kAircraftWhite);
        addWingPanel(body, {{{{2.4, side * 5.75, 2.7}, 3.6, 0.09}, {{0.8, side * 5.75, 3.2}, 2.8, 0.09}}});
    }
}

} // namespace

EntityModel makeAirliner(const EntityShape& shape)
{
    const glm::vec3 trim(shape.red, shape.green, shape.blue);
    Airframe frame;
    addAirlinerFuselage(frame.body(), trim);
    addWingsOf(frame, trim);
    addEngines(frame.body(), trim);
    frame.addLeg(0, {12.7, 0.0, 2.2}, {12.7, 0.0, 0.0}, 0.40, 0.55);
    frame.addLeg(1, {0.2, 3.8, 2.8}, {0.0, 3.8, 0.0}, 0.58, 0.95);
    frame.addLeg(2, {0.2, -3.8, 2.8}, {0.0, -3.8, 0.0}, 0.58, 0.95);
    frame.addNavigationLamps({-6.3, 16.95, 4.35}, {-19.6, 0.0, kAirlinerAxisZM + 1.3},
                             {2.0, 0.0, kAirlinerAxisZM + 2.1});
    for (const double side : {2.3, -2.3})
        frame.addLamp(EntityLamp::Kind::landing, {3.2, side, 2.85}, 0.0, 0.5);
    return frame.finish(shape.lengthM / kAirlinerLengthM, glm::dvec3(15.6, 0.5, kAirlinerAxisZM + 0.9));
}

} // namespace scenery::models
