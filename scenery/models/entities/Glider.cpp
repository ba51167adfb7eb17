// SPDX-License-Identifier: Apache-2.0
// A single-seat glider of 15 m span with a T-tail, 6.8 m long, 1.4 m high, on one wheel. Origin: on the
// ground below the wheel.
#include "scenery/models/entities/Airframe.h"
#include "scenery/models/entities/EntityGenerators.h"

namespace scenery::models
{

namespace
{

constexpr double kGliderLengthM = 6.8;
constexpr int kGliderSides = 24;

void addGliderFuselage(ModelBuilder& body)
{
    const auto rings = fuselageRings({{-4.55, 0.62, 0.05, 0.07},
                                      {-3.5, 0.60, 0.07, 0.09},
                                      {-1.6, 0.58, 0.11, 0.14},
                                      {-0.7, 0.59, 0.19, 0.25},
                                      {-0.2, 0.60, 0.27, 0.36},
                                      {0.2, 0.60, 0.31, 0.42},
                                      {0.7, 0.58, 0.315, 0.43},
                                      {1.2, 0.54, 0.30, 0.38},
                                      {1.7, 0.49, 0.24, 0.28},
                                      {2.05, 0.45, 0.15, 0.17},
                                      {2.2, 0.43, 0.05, 0.06}},
                                     2.2);
    body.begin("fuselage", kAircraftPaint, kAircraftWhite);
    addLoft(body, rings, kGliderSides);
    body.begin("canopy", kAircraftPaint, kCanopy);
    addBand(body, rings, kGliderSides, {6, 9, 1, 11}); // points 0 to 12: the upper half
}

} // namespace

EntityModel makeGlider(const EntityShape& shape)
{
    const glm::vec3 trim(shape.red, shape.green, shape.blue);
    const AerofoilStation root{{0.35, 0.0, 0.82}, 0.95, 0.15}, inner{{0.33, 4.0, 0.96}, 0.85, 0.15},
        outer{{0.22, 6.7, 1.08}, 0.55}, tip{{0.10, 7.5, 1.16}, 0.34};
    Airframe frame;
    addGliderFuselage(frame.body());
    Airframe::Wing wing;
    wing.stations = {root, inner, outer, tip};
    wing.hingeShare = 0.78;
    wing.hingedFrom = 1;
    wing.hingedTo = 2;
    wing.left = AircraftJoint::leftAileron;
    wing.right = AircraftJoint::rightAileron;
    frame.addWings(wing);
    Airframe::Wing fin;
    fin.stations = {{{-3.55, 0.0, 0.58}, 1.05}, {{-3.75, 0.0, 1.42}, 0.80}};
    fin.hingeShare = 0.66;
    fin.tint = trim;
    frame.addWing(fin, AircraftJoint::rudder);
    Airframe::Wing tail;
    tail.stations = {{{-3.80, 0.0, 1.45}, 0.58}, {{-3.92, 1.25, 1.47}, 0.34}};
    tail.hingeShare = 0.72;
    frame.addWings(tail);
    frame.addLeg(0, {0.12, 0.0, 0.35}, {0.10, 0.0, 0.0}, 0.17, 0.12);
    return frame.finish(shape.lengthM / kGliderLengthM, glm::dvec3(0.75, 0.0, 0.88));
}

} // namespace scenery::models
