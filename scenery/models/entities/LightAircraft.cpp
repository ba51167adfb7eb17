// SPDX-License-Identifier: Apache-2.0
// A single-engined high-wing aeroplane, 8.1 m long, 11 m span, 2.75 m high. Origin: on the ground below the
// axle of the main wheels.
#include "scenery/models/entities/Airframe.h"
#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/LightAircraftForm.h"

namespace scenery::models
{

namespace
{

constexpr int kLightSides = 32;

void addLightFuselage(ModelBuilder& body, const glm::vec3& trim)
{
    const auto rings = fuselageRings({kLightSections.begin(), kLightSections.end()}, kLightRoundness);
    body.begin("fuselage", kAircraftPaint, kAircraftWhite);
    addLoft(body, rings, kLightSides);
    // Ring points run from the left side (0) over the top (8) to the right side (16). Ring 0 is the tail's
    // tip.
    body.begin("windows", kAircraftPaint, kCanopy);
    addBand(body, rings, kLightSides, {9, 11, 2, 14}); // windscreen
    for (const auto& [from, to] : {std::pair{1, 5}, {11, 15}})
    {
        addBand(body, rings, kLightSides, {7, 8, from, to}); // doors
        addBand(body, rings, kLightSides, {5, 6, from, to}); // rear windows
    }
    body.begin("stripe", kAircraftPaint, trim);
    for (const auto& [from, to] : {std::pair{31, 32}, {16, 17}})
        addBand(body, rings, kLightSides, {2, 14, from, to, 0.006});
    body.begin("air intake", kPlain, kAircraftTyre);
    box(body, {2.25, -0.24, 1.02}, {2.352, 0.24, 1.10});
}

void addLightTail(Airframe& frame, const glm::vec3& trim)
{
    Airframe::Wing tail;
    tail.stations = {{{-4.05, 0.05, 1.55}, 1.05}, {{-4.25, 1.65, 1.55}, 0.75}, {{-4.35, 1.72, 1.55}, 0.50}};
    tail.hingeShare = 0.58;
    frame.addWings(tail);
    Airframe::Wing fin;
    fin.tint = trim;
    fin.stations = {{{-2.9, 0.0, 1.62}, 2.30, 0.06},
                    {{-3.85, 0.0, 1.80}, 1.40, 0.10},
                    {{-4.55, 0.0, 2.60}, 0.90},
                    {{-4.72, 0.0, 2.75}, 0.62}};
    fin.hingeShare = 0.62;
    fin.hingedFrom = 1;
    fin.hingedTo = 2;
    frame.addWing(fin, AircraftJoint::rudder);
}

void addWingsAndStruts(Airframe& frame, const glm::vec3& trim)
{
    frame.addFlappedWings(kLightWing, {{{{0.80, 5.4, 2.215}, 1.10}, {{0.60, 5.5, 2.22}, 0.70}}}, trim);
    ModelBuilder& body = frame.body();
    body.begin("struts", kAircraftPaint, kAircraftWhite);
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 across(1.0, side, 1.0);
        bar(body, across * kLightStrutLow, across * kLightStrutHigh, kLightStrutRadiusM);
    }
}

} // namespace

EntityModel makeLightAircraft(const EntityShape& shape)
{
    const glm::vec3 trim(shape.red, shape.green, shape.blue);
    Airframe frame;
    addLightFuselage(frame.body(), trim);
    addWingsAndStruts(frame, trim);
    addLightTail(frame, trim);
    frame.addLeg(0, {1.62, 0.0, 0.85}, {1.70, 0.0, 0.0}, 0.19, 0.14);
    frame.addLeg(1, {0.05, 0.40, 0.80}, {0.0, 1.26, 0.0}, 0.22, 0.16);
    frame.addLeg(2, {0.05, -0.40, 0.80}, {0.0, -1.26, 0.0}, 0.22, 0.16);
    ModelBuilder& body = frame.body();
    body.begin("spinner", kAircraftPaint, trim);
    addLimb(body, {2.34, 0.0, 1.22}, {2.50, 0.0, 1.22}, 0.17, 0.12);
    frame.addRotor({.hub = kLightPropellerHub, .axis = {1.0, 0.0, 0.0}, .radiusM = kLightPropellerRadiusM}, 2,
                   kLightPropellerChordM, kAircraftTyre);
    frame.addNavigationLamps({0.62, 5.5, 2.23}, {-5.3, 0.0, 1.52}, {-5.0, 0.0, 2.80});
    frame.addLamp(EntityLamp::Kind::landing, {2.36, 0.0, 0.98}, 0.0, 0.6);
    return frame.finish(shape.lengthM / kLightLengthM, glm::dvec3(0.45, 0.27, 1.75));
}

} // namespace scenery::models
