// SPDX-License-Identifier: Apache-2.0
// A single-engined low-wing aeroplane, 7.2 m long, 10.6 m span, 2.3 m high. Origin: on the ground below the
// axle of the main wheels.
#include "scenery/models/entities/Airframe.h"
#include "scenery/models/entities/EntityGenerators.h"

namespace scenery::models
{

namespace
{

constexpr int kSides = 32;
constexpr glm::dvec3 kHub{2.46, 0.0, 1.12};

void addFuselage(ModelBuilder& body, const glm::vec3& trim)
{
    const auto rings = fuselageRings({{-4.62, 1.34, 0.04, 0.12},
                                      {-3.60, 1.28, 0.16, 0.23},
                                      {-2.30, 1.24, 0.33, 0.42},
                                      {-1.35, 1.25, 0.47, 0.58},
                                      {-0.60, 1.27, 0.53, 0.66},
                                      {-0.50, 1.27, 0.54, 0.67},
                                      {0.42, 1.28, 0.56, 0.67},
                                      {0.54, 1.27, 0.56, 0.66},
                                      {1.05, 1.16, 0.55, 0.53},
                                      {1.30, 1.12, 0.53, 0.47},
                                      {1.75, 1.11, 0.50, 0.44},
                                      {2.15, 1.11, 0.43, 0.38},
                                      {2.36, 1.12, 0.32, 0.28},
                                      {2.42, 1.12, 0.20, 0.18}},
                                     2.6);
    body.begin("fuselage", kAircraftPaint, kAircraftWhite);
    addLoft(body, rings, kSides);
    // As in the high-wing aeroplane: points from the left side (0) over the top (8) to the right side (16).
    body.begin("windows", kAircraftPaint, kCanopy);
    addBand(body, rings, kSides, {7, 9, 2, 14}); // windscreen
    for (const auto& [from, to] : {std::pair{1, 6}, {10, 15}})
    {
        addBand(body, rings, kSides, {5, 6, from, to});
        addBand(body, rings, kSides, {3, 4, from, to});
    }
    body.begin("stripe", kAircraftPaint, trim);
    for (const auto& [from, to] : {std::pair{29, 31}, {17, 19}})
        addBand(body, rings, kSides, {1, 12, from, to, 0.006});
    body.begin("air intake", kPlain, kAircraftTyre);
    box(body, {2.33, -0.22, 1.10}, {2.432, 0.22, 1.18});
}

constexpr std::array<AerofoilStation, 4> kWing{{{{1.25, 0.0, 0.84}, 2.05, 0.15},
                                                {{0.98, 0.75, 0.92}, 1.60, 0.14},
                                                {{0.98, 2.9, 1.15}, 1.60, 0.14},
                                                {{0.98, 5.0, 1.38}, 1.60, 0.13}}};
constexpr std::array<AerofoilStation, 2> kTip{
    {{{0.88, 5.25, 1.41}, 1.35, 0.10}, {{0.60, 5.3, 1.42}, 0.80, 0.08}}};

void addTail(Airframe& frame, const glm::vec3& trim)
{
    Airframe::Wing tail;
    tail.stations = {{{-3.95, 0.05, 1.34}, 0.78}, {{-3.98, 1.55, 1.34}, 0.74}, {{-4.05, 1.62, 1.34}, 0.55}};
    tail.hingeShare = 0.5;
    frame.addWings(tail);
    Airframe::Wing fin;
    fin.tint = trim;
    fin.stations = {
        {{-2.7, 0.0, 1.50}, 2.0, 0.06}, {{-3.50, 0.0, 1.68}, 1.20, 0.10}, {{-3.95, 0.0, 2.30}, 0.80}};
    fin.hingeShare = 0.62;
    fin.hingedFrom = 1;
    fin.hingedTo = 2;
    frame.addWing(fin, AircraftJoint::rudder);
}

} // namespace

EntityModel makeLowWingAircraft(const EntityShape& shape)
{
    const glm::vec3 trim(shape.red, shape.green, shape.blue);
    Airframe frame;
    addFuselage(frame.body(), trim);
    frame.addFlappedWings(kWing, kTip, trim);
    addTail(frame, trim);
    frame.addLeg(0, {1.70, 0.0, 0.75}, {1.78, 0.0, 0.0}, 0.19, 0.14);
    frame.addLeg(1, {0.10, 1.55, 0.98}, {0.0, 1.55, 0.0}, 0.21, 0.16);
    frame.addLeg(2, {0.10, -1.55, 0.98}, {0.0, -1.55, 0.0}, 0.21, 0.16);
    ModelBuilder& body = frame.body();
    body.begin("spinner", kAircraftPaint, trim);
    addLimb(body, {2.40, 0.0, 1.12}, {2.58, 0.0, 1.12}, 0.17, 0.10);
    frame.addRotor({.hub = kHub, .axis = {1.0, 0.0, 0.0}, .radiusM = 0.90}, 2, 0.16, kAircraftTyre);
    frame.addNavigationLamps({0.70, 5.3, 1.43}, {-4.7, 0.0, 1.34}, {-4.3, 0.0, 2.34});
    frame.addLamp(EntityLamp::Kind::landing, {2.44, 0.0, 0.92}, 0.0, 0.6);
    return frame.finish(1.0, glm::dvec3(0.35, 0.27, 1.62));
}

} // namespace scenery::models
