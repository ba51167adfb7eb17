// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/entities/TwoWheelerParts.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

struct BicyclePose
{
    RollingPose rolling; ///< the frame and the two wheels
    PersonSize size;
    glm::dvec3 hip, crank;
    double crankM, metresATurn;

    std::vector<glm::dmat4> operator()(const EntityMotion& motion) const
    {
        std::vector<glm::dmat4> pose = rolling(motion);
        pose.push_back(swungFrom(hip, -kRiderLeanRad));
        const double turn = std::fmod(motion.odometerM / metresATurn, 1.0) * 2.0 * std::numbers::pi;
        for (const double side : {1.0, -1.0})
        {
            const double at = turn + (side > 0.0 ? 0.0 : std::numbers::pi);
            const glm::dvec3 from(hip.x, side * size.halfHips(), hip.z);
            const glm::dvec3 ankle = crank + glm::dvec3(-0.06 + crankM * std::cos(at), from.y,
                                                        size.ankle() - crankM * std::sin(at));
            const LegBend bend = bendLeg(size.leg(), from, ankle);
            pose.push_back(swungFrom(from, bend.upperRad));
            pose.push_back(swungFrom(bend.joint, bend.lowerRad));
            pose.push_back(swungFrom(bend.end, -0.12));
        }
        pose.push_back(glm::rotate(glm::translate(glm::dmat4(1.0), crank), turn, glm::dvec3(0.0, 1.0, 0.0)));
        return pose;
    }
};

Model makeCrank(double armM)
{
    ModelBuilder builder;
    builder.begin("crank", kPlain, kBareMetal);
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 end(side * armM, side * 0.075, 0.0);
        bar(builder, {0.0, side * 0.06, 0.0}, end, 0.010);
        box(builder, end - glm::dvec3(0.045, side > 0.0 ? 0.0 : 0.08, 0.01),
            end + glm::dvec3(0.045, side > 0.0 ? 0.08 : 0.0, 0.01));
    }
    bar(builder, {0.0, -0.06, 0.0}, {0.0, 0.06, 0.0}, 0.09); // the chain wheel
    return builder.finish();
}

void addBicycleFrame(ModelBuilder& builder, const EntityShape& shape, const TwoWheels& wheels,
                     const glm::dvec3& crank, const glm::dvec3& saddle, const glm::dvec3& grip)
{
    const glm::dvec3 rear(wheels.rearX, 0.0, wheels.radius), front(wheels.frontX, 0.0, wheels.radius);
    const glm::dvec3 head = front + glm::dvec3(-0.17, 0.0, 0.42);
    builder.begin("frame", kPlain, tintOf(shape));
    bar(builder, crank, saddle, 0.017);
    bar(builder, crank, head - glm::dvec3(0.0, 0.0, 0.06), 0.020);
    bar(builder, saddle - glm::dvec3(0.0, 0.0, 0.1), head, 0.017);
    for (const double side : {0.05, -0.05})
    {
        const glm::dvec3 aside(0.0, side, 0.0);
        bar(builder, rear + aside, crank + 0.6 * aside, 0.010);
        bar(builder, rear + aside, saddle - glm::dvec3(0.0, 0.0, 0.12), 0.009);
        bar(builder, front + aside, head + 0.6 * aside, 0.012);
    }
    builder.begin("handlebar", kPlain, kBlackPaint);
    bar(builder, head, {grip.x - 0.03, 0.0, grip.z}, 0.016);
    bar(builder, {grip.x, -grip.y - 0.05, grip.z}, {grip.x, grip.y + 0.05, grip.z}, 0.013);
    builder.begin("saddle", kPlain, kBlackPaint);
    addLimb(builder, saddle + glm::dvec3(-0.08, 0.0, 0.03), saddle + glm::dvec3(0.12, 0.0, 0.03), 0.06,
            0.025);
}

} // namespace

EntityModel makeBicycle(const EntityShape& shape)
{
    const PersonSize size(1.75);
    const TwoWheels wheels(shape, 0.34);
    PersonColours colours;
    colours.jacket = tintOf(shape);
    colours.hair = {0.85F, 0.85F, 0.86F}; // the helmet
    const double base = wheels.frontX - wheels.rearX;
    const glm::dvec3 crank(wheels.rearX + 0.42 * base, 0.0, 0.29),
        saddle = crank + glm::dvec3(-0.19, 0.0, 0.62);
    const glm::dvec3 hip = saddle + glm::dvec3(0.0, 0.0, 0.12), grip(wheels.frontX - 0.16, 0.26, 1.06);
    EntityModel model;
    ModelBuilder frame;
    addBicycleFrame(frame, shape, wheels, crank, saddle, grip);
    addRider(frame, size, colours, hip, grip);
    model.parts = {model.addMesh(frame.finish())};
    BicyclePose pose{twoWheels(model, wheels, makeSpokedWheel(wheels.radius, 0.018, 16)),
                     size,
                     hip,
                     crank,
                     0.17,
                     2.5 * 2.0 * std::numbers::pi * wheels.radius};
    model.parts.push_back(model.addMesh(makeLeaningTrunk(size, colours)));
    const std::size_t thigh = model.addMesh(makeThigh(size, colours)),
                      shank = model.addMesh(makeShank(size, colours)),
                      shoe = model.addMesh(makeShoe(size, colours));
    model.parts.insert(model.parts.end(),
                       {thigh, shank, shoe, thigh, shank, shoe, model.addMesh(makeCrank(0.17))});
    model.pose = std::move(pose);
    model.eye = hip + glm::dvec3(0.45, 0.0, 0.62);
    addLampsOfTwoWheeler(model, {grip.x + 0.08, 0.0, grip.z - 0.1}, {wheels.rearX - 0.2, 0.0, 0.62});
    return model;
}

} // namespace scenery::models
