// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/entities/TwoWheelerParts.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

EntityModel makeWheelchair(const EntityShape& shape)
{
    constexpr double kSeatM = 0.50, kRadiusM = 0.30;
    const PersonSize size(1.70);
    PersonColours colours;
    colours.jacket = tintOf(shape);
    const glm::dvec3 hip(shape.middleXM - 0.05, 0.0, kSeatM + 0.08);
    ModelBuilder body;
    body.begin("seat", kPlain, kBlackPaint);
    box(body, {hip.x - 0.22, -0.22, kSeatM - 0.04}, {hip.x + 0.24, 0.22, kSeatM});
    box(body, {hip.x - 0.24, -0.22, kSeatM}, {hip.x - 0.20, 0.22, kSeatM + 0.45});
    body.begin("frame", kPlain, kBareMetal);
    for (const double side : {0.23, -0.23})
    {
        bar(body, {hip.x - 0.22, side, kSeatM + 0.5}, {hip.x - 0.22, side, 0.25}, 0.013);
        bar(body, {hip.x - 0.22, side, 0.25}, {hip.x + 0.35, side, 0.15}, 0.013);
        bar(body, {hip.x + 0.24, side, kSeatM}, {hip.x + 0.45, side, 0.12}, 0.013);
    }
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 from = hip + glm::dvec3(0.0, side * size.halfHips(), 0.0);
        const LegBend bend = bendLeg(size.leg(), from, {hip.x + 0.46, from.y, 0.20});
        addLeg(body, size, colours, from, bend.joint, bend.end);
        const glm::dvec3 shoulder =
            hip + glm::dvec3(0.0, side * size.halfShoulders(), 0.97 * size.shoulderAboveHip());
        addArm(body, size, colours, shoulder, shoulder + glm::dvec3(-0.06, side * 0.08, -0.28),
               {hip.x + 0.12, side * 0.27, kSeatM + 0.16});
    }
    ModelBuilder trunk;
    addTrunk(trunk, size, colours, false);
    EntityModel model;
    model.parts = {model.addMesh(body.finish())};
    const std::size_t wheel = model.addMesh(makeSpokedWheel(kRadiusM, 0.018, 16));
    const std::size_t caster = model.addMesh(makeSpokedWheel(0.09, 0.02, 4));
    model.parts.insert(model.parts.end(), {wheel, wheel, caster, caster, model.addMesh(trunk.finish())});
    RollingPose rolling;
    for (const double side : {1.0, -1.0})
        rolling.wheels.push_back({{hip.x - 0.05, side * 0.29, kRadiusM}, kRadiusM, false, -1});
    for (const double side : {1.0, -1.0})
        rolling.wheels.push_back({{hip.x + 0.32, side * 0.22, 0.09}, 0.09, true, -1});
    model.pose = [rolling, hip](const EntityMotion& motion)
    {
        std::vector<glm::dmat4> pose = rolling(motion);
        pose.push_back(swungFrom(hip, 0.08));
        return pose;
    };
    model.eye = hip + glm::dvec3(0.1, 0.0, 0.68);
    return model;
}

} // namespace scenery::models
