// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/entities/TwoWheelerParts.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

/// The places that the parts of a motorbike hang on. Frame: the entity's.
struct MotorbikePlaces
{
    explicit MotorbikePlaces(const EntityShape& shape) : wheels(shape, 0.31)
    {
        const double base = wheels.frontX - wheels.rearX;
        middle = wheels.rearX + 0.45 * base;
        hip = {wheels.rearX + 0.34 * base, 0.0, 0.90};
        grip = {wheels.frontX - 0.42, 0.33, 1.02};
    }

    TwoWheels wheels;
    double middle = 0.0;
    glm::dvec3 hip{0.0}, grip{0.0};
};

void addMachine(ModelBuilder& body, const EntityShape& shape, const MotorbikePlaces& places)
{
    const TwoWheels& wheels = places.wheels;
    const double middle = places.middle;
    const glm::dvec3& grip = places.grip;
    body.begin("tank", {Painting::plain, Coat::lacquered}, tintOf(shape));
    addHull(body,
            {{middle - 0.05, 0.10, 0.72, 0.82},
             {middle + 0.08, 0.15, 0.66, 0.93},
             {middle + 0.30, 0.16, 0.66, 0.97},
             {middle + 0.52, 0.08, 0.74, 0.92}},
            2.6);
    body.begin("tail", {Painting::plain, Coat::lacquered}, tintOf(shape));
    addHull(body,
            {{wheels.rearX - 0.22, 0.06, 0.72, 0.82},
             {wheels.rearX + 0.15, 0.11, 0.66, 0.82},
             {middle - 0.02, 0.12, 0.62, 0.78}},
            3.0);
    body.begin("engine", kPlain, kBlackPaint);
    addHull(body,
            {{middle - 0.12, 0.16, 0.26, 0.64},
             {middle + 0.10, 0.20, 0.24, 0.68},
             {middle + 0.38, 0.16, 0.28, 0.62}},
            5.0);
    body.begin("exhaust", kPlain, kBareMetal);
    addLimb(body, {middle + 0.2, -0.20, 0.28}, {wheels.rearX - 0.15, -0.20, 0.36}, 0.035, 0.06);
    for (const double side : {0.11, -0.11})
    {
        bar(body, {wheels.frontX, side, wheels.radius}, {wheels.frontX - 0.30, side, 0.98}, 0.026);
        bar(body, {wheels.rearX, side, wheels.radius}, {middle, side, 0.42}, 0.03);
    }
    bar(body, {grip.x, -grip.y - 0.06, grip.z}, {grip.x, grip.y + 0.06, grip.z}, 0.016);
    body.begin("head lamp", kPlain, {0.88F, 0.89F, 0.90F});
    addLimb(body, {wheels.frontX - 0.24, 0.0, 0.88}, {wheels.frontX - 0.17, 0.0, 0.88}, 0.09, 0.085);
}

} // namespace

EntityModel makeMotorbike(const EntityShape& shape)
{
    const PersonSize size(1.78);
    const MotorbikePlaces places(shape);
    const TwoWheels& wheels = places.wheels;
    const glm::dvec3 &hip = places.hip, &grip = places.grip;
    PersonColours colours;
    colours.jacket = {0.10F, 0.10F, 0.11F};
    colours.hair = tintOf(shape); // the helmet
    ModelBuilder body;
    addMachine(body, shape, places);
    addRider(body, size, colours, hip, grip);
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 from = hip + glm::dvec3(0.0, side * 0.13, 0.0);
        const LegBend bend = bendLeg(size.leg(), from, {places.middle - 0.06, from.y + side * 0.06, 0.36});
        addLeg(body, size, colours, from, bend.joint + glm::dvec3(0.0, side * 0.08, 0.0), bend.end);
    }
    EntityModel model;
    model.parts = {model.addMesh(body.finish())};
    const RollingPose rolling = twoWheels(model, wheels, makeSpokedWheel(wheels.radius, 0.055, 6));
    model.parts.push_back(model.addMesh(makeLeaningTrunk(size, colours)));
    model.pose = [rolling, hip = hip](const EntityMotion& motion)
    {
        std::vector<glm::dmat4> pose = rolling(motion);
        pose.push_back(swungFrom(hip, -kRiderLeanRad));
        return pose;
    };
    model.eye = hip + glm::dvec3(0.45, 0.0, 0.65);
    addLampsOfTwoWheeler(model, {wheels.frontX - 0.07, 0.0, 0.88}, {wheels.rearX - 0.24, 0.0, 0.74});
    return model;
}

} // namespace scenery::models
