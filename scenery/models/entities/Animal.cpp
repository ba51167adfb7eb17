// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Gait.h"
#include "scenery/models/entities/LegBend.h"
#include "scenery/models/mesh/Loft.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr double kAntlersFromM = 1.6; ///< animals as high as that have antlers

/// The lengths of an animal on four legs. Units: metres.
struct AnimalSize
{
    explicit AnimalSize(const EntityShape& shape)
        : length(shape.lengthM),
          height(shape.heightM),
          middleX(shape.middleXM),
          thick(std::max(0.5 * shape.widthM, 0.13 * shape.heightM))
    {
    }

    double length, height, middleX, thick;
    double hipZ() const { return 0.50 * height; }
    double frontX() const { return middleX + 0.16 * length; }
    double hindX() const { return middleX - 0.30 * length; }
    Leg foreleg() const { return {0.27 * height, 0.26 * height, true}; }
    Leg hindleg() const { return {0.27 * height, 0.26 * height, false}; }
    Gait gait() const { return {0.75 * height, 0.08 * height}; }
};

struct AnimalPose
{
    AnimalSize size;

    std::vector<glm::dmat4> operator()(const EntityMotion& motion) const
    {
        std::vector<glm::dmat4> pose{glm::dmat4(1.0)};
        for (const bool isFore : {true, false})
            for (const double side : {1.0, -1.0})
            {
                const double offset = (isFore == (side > 0.0)) ? 0.0 : 0.5; // a trot: diagonal legs together
                const FootPlace foot = footPlace(size.gait(), motion, offset);
                const glm::dvec3 hip(isFore ? size.frontX() : size.hindX(), side * 0.55 * size.thick,
                                     size.hipZ());
                const LegBend bend = bendLeg(isFore ? size.foreleg() : size.hindleg(), hip,
                                             {hip.x + foot.aheadM, hip.y, foot.aboveM + 0.01});
                pose.push_back(swungFrom(hip, bend.upperRad));
                pose.push_back(swungFrom(bend.joint, bend.lowerRad));
            }
        return pose;
    }
};

LoftRing upright(double x, double z, double wide, double high)
{
    return {{x, 0.0, z}, {0.0, wide, 0.0}, {0.0, 0.0, high}, 2.3};
}

void addHead(ModelBuilder& builder, const AnimalSize& size, const glm::vec3& coat)
{
    const double h = size.height, nose = size.middleX + 0.5 * size.length;
    const glm::dvec3 withers(size.frontX() + 0.04 * size.length, 0.0, 0.70 * h);
    const glm::dvec3 poll(nose - 0.20 * size.length, 0.0, 0.90 * h), muzzle(nose - 0.03 * h, 0.0, 0.76 * h);
    builder.begin("neck", kRoadSigns, coat);
    addLimb(builder, withers, poll, 0.13 * h, 0.075 * h);
    builder.begin("head", kRoadSigns, coat);
    addLimb(builder, poll, muzzle, 0.075 * h, 0.045 * h);
    builder.begin("ears", kRoadSigns, coat);
    for (const double side : {1.0, -1.0})
        addLimb(builder, poll + glm::dvec3(-0.02 * h, side * 0.04 * h, 0.05 * h),
                poll + glm::dvec3(-0.04 * h, side * 0.10 * h, 0.12 * h), 0.022 * h, 0.010 * h);
    if (h < kAntlersFromM) return;
    builder.begin("antlers", kRoadSigns, {0.62F, 0.55F, 0.42F});
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 root = poll + glm::dvec3(0.0, side * 0.05 * h, 0.06 * h);
        const glm::dvec3 palm = root + glm::dvec3(-0.04 * h, side * 0.17 * h, 0.03 * h);
        addLimb(builder, root, palm, 0.015 * h, 0.02 * h);
        for (const double tine : {-0.10, -0.03, 0.04, 0.10})
            addLimb(builder, palm, palm + glm::dvec3(tine * h, side * 0.07 * h, 0.07 * h), 0.02 * h,
                    0.008 * h);
    }
}

Model makeTrunk(const AnimalSize& size, const glm::vec3& coat)
{
    const double h = size.height, back = size.hindX() - 0.13 * size.length,
                 front = size.frontX() + 0.10 * size.length;
    const double span = front - back, w = size.thick;
    ModelBuilder builder;
    builder.begin("trunk", kRoadSigns, coat);
    addLoft(builder,
            {upright(back, 0.60 * h, 0.0, 0.0), upright(back + 0.02 * span, 0.60 * h, 0.45 * w, 0.09 * h),
             upright(back + 0.12 * span, 0.59 * h, 0.85 * w, 0.135 * h),
             upright(back + 0.30 * span, 0.58 * h, 0.92 * w, 0.135 * h),
             upright(back + 0.55 * span, 0.565 * h, w, 0.155 * h),
             upright(back + 0.80 * span, 0.585 * h, 0.92 * w, 0.175 * h),
             upright(back + 0.94 * span, 0.60 * h, 0.62 * w, 0.14 * h), upright(front, 0.60 * h, 0.0, 0.0)},
            20);
    builder.begin("tail", kRoadSigns, coat);
    addLimb(builder, {back + 0.01, 0.0, 0.66 * h}, {back - 0.03 * h, 0.0, 0.55 * h}, 0.02 * h, 0.012 * h);
    addHead(builder, size, coat);
    return builder.finish();
}

Model makeBone(double lengthM, double fromM, double toM, const glm::vec3& tint)
{
    ModelBuilder builder;
    builder.begin("bone", kRoadSigns, tint);
    addLimb(builder, {}, {0.0, 0.0, -lengthM}, fromM, toM);
    return builder.finish();
}

} // namespace

EntityModel makeAnimal(const EntityShape& shape)
{
    const AnimalSize size(shape);
    const glm::vec3 coat(shape.red, shape.green, shape.blue);
    EntityModel model;
    model.parts = {model.addMesh(makeTrunk(size, coat))};
    const double h = shape.heightM;
    const std::size_t upper = model.addMesh(makeBone(size.foreleg().upperM, 0.075 * h, 0.038 * h, coat));
    const std::size_t lower =
        model.addMesh(makeBone(size.foreleg().lowerM - 0.02 * h, 0.034 * h, 0.022 * h, 0.75F * coat));
    for (int leg = 0; leg < 4; ++leg)
        model.parts.insert(model.parts.end(), {upper, lower});
    model.pose = AnimalPose{size};
    model.eye = {shape.frontXM(), 0.0, 0.9 * h};
    return model;
}

} // namespace scenery::models
