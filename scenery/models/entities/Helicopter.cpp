// SPDX-License-Identifier: Apache-2.0
// A light helicopter on skids: 11 m long without its rotor, three blades of 5.3 m, 3.2 m high. Origin: on the
// ground below the cabin's middle of mass.
#include "scenery/models/entities/Airframe.h"
#include "scenery/models/entities/EntityGenerators.h"

namespace scenery::models
{

namespace
{

constexpr double kHelicopterLengthM = 11.0;
constexpr int kHelicopterSides = 32;

void addHelicopterFuselage(ModelBuilder& body, const glm::vec3& paint)
{
    const auto rings = fuselageRings({{-7.6, 2.02, 0.09, 0.10},
                                      {-5.5, 1.92, 0.14, 0.16},
                                      {-2.6, 1.78, 0.24, 0.28},
                                      {-1.6, 1.60, 0.52, 0.60},
                                      {-0.6, 1.42, 0.80, 0.86},
                                      {0.5, 1.36, 0.88, 0.92},
                                      {1.4, 1.30, 0.85, 0.86},
                                      {2.2, 1.16, 0.68, 0.64},
                                      {2.7, 1.02, 0.40, 0.36},
                                      {2.9, 0.95, 0.12, 0.10}},
                                     2.5);
    body.begin("fuselage", kAircraftPaint, paint);
    addLoft(body, rings, kHelicopterSides);
    body.begin("windows", kAircraftPaint, kCanopy);
    addBand(body, rings, kHelicopterSides, {7, 9, 0, 16, 0.012}); // the windscreen
    for (const auto& [from, to] : {std::pair{0, 5}, {11, 16}})
        addBand(body, rings, kHelicopterSides, {5, 6, from, to, 0.012});
    body.begin("engine", kAircraftPaint, paint);
    addHull(body,
            {{-1.9, 0.30, 1.9, 2.3}, {-1.0, 0.42, 1.9, 2.62}, {0.3, 0.36, 1.9, 2.60}, {0.8, 0.2, 1.9, 2.3}},
            3.0);
    body.begin("mast", kPlain, kAircraftMetal);
    bar(body, {-0.1, 0.0, 2.5}, {-0.1, 0.0, 3.12}, 0.07);
    bar(body, {-0.1, 0.0, 3.02}, {-0.1, 0.0, 3.14}, 0.20);
}

void addSkids(ModelBuilder& body)
{
    body.begin("skids", kPlain, kAircraftMetal);
    for (const double side : {1.0, -1.0})
    {
        addLimb(body, {-1.5, side * 1.05, 0.05}, {1.9, side * 1.05, 0.05}, 0.05, 0.05);
        addLimb(body, {1.9, side * 1.05, 0.05}, {2.25, side * 1.05, 0.25}, 0.05, 0.04);
        for (const double x : {-0.9, 1.1})
            bar(body, {x, side * 0.5, 0.62}, {x, side * 1.05, 0.05}, 0.04);
    }
}

} // namespace

EntityModel makeHelicopter(const EntityShape& shape)
{
    const glm::vec3 paint(shape.red, shape.green, shape.blue);
    Airframe frame;
    addHelicopterFuselage(frame.body(), paint);
    addSkids(frame.body());
    ModelBuilder& body = frame.body();
    body.begin("fins", kAircraftPaint, paint);
    addWingPanel(body, {{{{-6.9, 0.0, 1.35}, 0.75, 0.10},
                         {{-6.75, 0.0, 1.95}, 0.90, 0.10},
                         {{-7.45, 0.0, 3.0}, 0.55, 0.10}}});
    addWingPanel(body, {{{{-5.6, -1.1, 1.92}, 0.5, 0.10}, {{-5.6, 1.1, 1.92}, 0.5, 0.10}}});
    frame.addRotor({.hub = {-0.1, 0.0, 3.10}, .axis = {0.0, 0.0, 1.0}, .radiusM = 5.3, .hubRadiusM = 0.3}, 3,
                   0.32, kAircraftTyre);
    frame.addRotor({.hub = {-7.45, 0.20, 2.10},
                    .axis = {0.0, 1.0, 0.0},
                    .radiusM = 0.93,
                    .hubRadiusM = 0.1,
                    .turns = 5.0},
                   2, 0.19, kAircraftTyre);
    frame.addNavigationLamps({-5.5, 1.12, 1.94}, {-8.0, 0.0, 2.05}, {-1.6, 0.0, 2.55});
    frame.addLamp(EntityLamp::Kind::landing, {2.6, 0.0, 0.72}, 0.0, 0.6);
    return frame.finish(shape.lengthM / kHelicopterLengthM, glm::dvec3(1.5, -0.4, 1.75));
}

} // namespace scenery::models
