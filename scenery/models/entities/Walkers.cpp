// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Gait.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/entities/Person.h"
#include "scenery/models/roads/SignAtlas.h"

namespace scenery::models
{

namespace
{

PersonColours coloursOf(const EntityShape& shape)
{
    PersonColours colours;
    colours.jacket = {shape.red, shape.green, shape.blue};
    return colours;
}

/// Returns how high the hips are above the ground: lower while a foot is far ahead, as over an inverted
/// pendulum.
double hipHeight(const PersonSize& size, const Gait& gait, const EntityMotion& motion)
{
    constexpr double kStraight = 0.997, kFollowed = 0.92;
    const double reach = kStraight * (size.hip() - size.ankle());
    const double phase = gait.phase(motion.odometerM, 0.0);
    const double step = 0.25 * gait.strideM * Gait::vigour(motion.speedMps);
    const double ahead = step * std::cos(2.0 * std::numbers::pi * phase); // at most `step`, twice a stride
    const double low = std::sqrt(reach * reach - ahead * ahead);
    return size.ankle() + kFollowed * low + (1.0 - kFollowed) * std::sqrt(reach * reach - step * step);
}

struct WalkerPose
{
    PersonSize size;
    Gait gait;

    std::vector<glm::dmat4> operator()(const EntityMotion& motion) const
    {
        const double hipM = hipHeight(size, gait, motion);
        const double swing = 0.5 * Gait::vigour(motion.speedMps);
        std::vector<glm::dmat4> pose{glm::translate(glm::dmat4(1.0), {0.0, 0.0, hipM})};
        for (const double side : {1.0, -1.0})
        {
            const double offset = side > 0.0 ? 0.0 : 0.5;
            const FootPlace foot = footPlace(gait, motion, offset);
            const glm::dvec3 hip(0.0, side * size.halfHips(), hipM);
            const LegBend bend = bendLeg(size.leg(), hip, {foot.aheadM, hip.y, size.ankle() + foot.aboveM});
            pose.push_back(swungFrom(hip, bend.upperRad));
            pose.push_back(swungFrom(bend.joint, bend.lowerRad));
            pose.push_back(swungFrom(bend.end, -foot.toeDownRad));
            const double arm =
                -swing * std::cos(2.0 * std::numbers::pi * gait.phase(motion.odometerM, offset));
            pose.push_back(
                swungFrom({0.0, side * size.halfShoulders(), hipM + 0.97 * size.shoulderAboveHip()}, arm));
        }
        return pose;
    }
};

/// An arm that hangs down, a little bent. Frame: origin at the shoulder.
Model makeHangingArm(const PersonSize& size, const PersonColours& colours)
{
    ModelBuilder builder;
    const glm::dvec3 elbow(0.0, 0.0, -size.upperArm());
    addArm(builder, size, colours, {}, elbow,
           elbow + size.forearm() * glm::dvec3(std::sin(0.3), 0.0, -std::cos(0.3)));
    return builder.finish();
}

} // namespace

EntityModel makePedestrian(const EntityShape& shape)
{
    const PersonSize size(shape.heightM);
    const PersonColours colours = coloursOf(shape);
    ModelBuilder trunk;
    addTrunk(trunk, size, colours, false);
    EntityModel model;
    const std::size_t body = model.addMesh(trunk.finish());
    const std::size_t thigh = model.addMesh(makeThigh(size, colours));
    const std::size_t shank = model.addMesh(makeShank(size, colours));
    const std::size_t shoe = model.addMesh(makeShoe(size, colours));
    const std::size_t arm = model.addMesh(makeHangingArm(size, colours));
    model.parts = {body, thigh, shank, shoe, arm, thigh, shank, shoe, arm};
    model.pose = WalkerPose{size, {0.72 * shape.heightM, 0.07 * shape.heightM}};
    model.eye = {0.1, 0.0, 0.936 * shape.heightM};
    model.shadowHalfLengthM = model.shadowHalfWidthM = 0.12 * shape.heightM;
    return model;
}

} // namespace scenery::models
