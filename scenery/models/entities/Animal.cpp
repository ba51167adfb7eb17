// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Gait.h"
#include "scenery/models/entities/LegBend.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr double kPalmedFromM = 1.6; ///< deer as high as that are moose
constexpr glm::vec3 kEye(0.03F, 0.03F, 0.03F), kHorn(0.62F, 0.55F, 0.42F), kHoof(0.12F, 0.10F, 0.09F);

/// How an animal is built. Lengths as shares of `bodyShare` times its height, unless said otherwise.
struct AnimalForm
{
    double bodyShare;      ///< of the height: higher for those that carry their head low
    double pollZ, muzzleZ; ///< of the head's two ends
    double headLength;     ///< from the nose back, of the length
    double neckFrom, neckTo, headFrom, headTo;
    double thick; ///< of the trunk, at least
    double legM, legFrom;
    double tailDrop, tailBack, tailRadius;
    double earUp, earAside;
    double trunkHigh = 1.0; ///< against that of a horse
};

const AnimalForm& formOf(EntityKind kind)
{
    static constexpr AnimalForm kHorse{1.0,  0.90, 0.76,  0.20, 0.13, 0.075, 0.075, 0.045,
                                       0.13, 0.53, 0.075, 0.34, 0.10, 0.030, 0.09,  0.05};
    static constexpr AnimalForm kCow{1.17, 0.78,  0.60, 0.16, 0.14,  0.10, 0.095, 0.065, 0.20,
                                     0.50, 0.075, 0.36, 0.03, 0.012, 0.02, 0.14,  1.12};
    static constexpr AnimalForm kSheep{1.10, 0.84, 0.71, 0.18, 0.13,  0.09,  0.075, 0.045, 0.24,
                                       0.50, 0.06, 0.16, 0.02, 0.030, -0.02, 0.12,  1.35};
    static constexpr AnimalForm kDeer{0.80, 0.92, 0.82, 0.18, 0.105, 0.055, 0.065, 0.034,
                                      0.13, 0.54, 0.06, 0.08, 0.03,  0.022, 0.08,  0.08};
    static constexpr AnimalForm kDog{1.0,  0.90,  0.80,  0.22, 0.115, 0.085, 0.095, 0.045, 0.15,
                                     0.50, 0.055, -0.10, 0.22, 0.018, 0.09,  0.06,  0.85};
    switch (kind)
    {
    case EntityKind::cow:
        return kCow;
    case EntityKind::sheep:
        return kSheep;
    case EntityKind::deer:
        return kDeer;
    case EntityKind::dog:
        return kDog;
    default:
        return kHorse;
    }
}

bool isMoose(const EntityShape& shape)
{
    return shape.kind == EntityKind::deer && shape.heightM >= kPalmedFromM;
}

/// The lengths of an animal on four legs. Units: metres.
struct AnimalSize
{
    explicit AnimalSize(const EntityShape& shape)
        : form(&formOf(shape.kind)),
          kind(shape.kind),
          length(shape.lengthM),
          height((isMoose(shape) ? 1.0 : form->bodyShare) * shape.heightM),
          middleX(shape.middleXM),
          thick(std::max(0.5 * shape.widthM, form->thick * height))
    {
    }

    const AnimalForm* form;
    EntityKind kind;
    double length, height, middleX, thick;
    double hipZ() const { return 0.50 * height; }
    double frontX() const { return middleX + 0.16 * length; }
    double hindX() const { return middleX - 0.30 * length; }
    Leg foreleg() const { return {0.51 * form->legM * height, 0.49 * form->legM * height, true}; }
    Leg hindleg() const { return {0.51 * form->legM * height, 0.49 * form->legM * height, false}; }
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

/// Antlers of a moose are palms with tines, those of other deer branch from a beam.
void addAntlers(ModelBuilder& builder, double h, const glm::dvec3& poll, bool isMoose)
{
    builder.begin("antlers", kPlain, kHorn);
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 root = poll + glm::dvec3(0.0, side * 0.05 * h, 0.06 * h);
        const glm::dvec3 end = root + (isMoose ? glm::dvec3(-0.04 * h, side * 0.17 * h, 0.03 * h)
                                               : glm::dvec3(-0.12 * h, side * 0.12 * h, 0.26 * h));
        addLimb(builder, root, end, 0.015 * h, isMoose ? 0.02 * h : 0.008 * h);
        for (const double tine : {-0.10, -0.03, 0.04, 0.10})
        {
            const glm::dvec3 from = isMoose ? end : glm::mix(root, end, 0.5 + 4.0 * tine);
            const glm::dvec3 way = isMoose ? glm::dvec3(tine * h, side * 0.07 * h, 0.07 * h)
                                           : glm::dvec3(0.09 * h, side * 0.03 * h, 0.07 * h);
            addLimb(builder, from, from + way, isMoose ? 0.02 * h : 0.010 * h, 0.006 * h);
        }
    }
}

void addFace(ModelBuilder& builder, const AnimalSize& size, const glm::dvec3& poll, const glm::dvec3& muzzle,
             const glm::vec3& coat)
{
    const double h = size.height;
    const AnimalForm& form = *size.form;
    builder.begin("ears", kPlain, 0.85F * coat);
    for (const double side : {1.0, -1.0})
        addLimb(builder, poll + glm::dvec3(-0.02 * h, side * 0.04 * h, 0.05 * h),
                poll + glm::dvec3(-0.04 * h, side * (0.04 + form.earAside) * h, (0.05 + form.earUp) * h),
                0.024 * h, 0.010 * h);
    builder.begin("eyes", kPlain, kEye);
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 eye = glm::mix(poll, muzzle, 0.30) +
                               glm::dvec3(0.0, side * 0.82 * form.headFrom * h, 0.35 * form.headFrom * h);
        addLimb(builder, eye, eye + glm::dvec3(0.004 * h, 0.0, 0.0), 0.016 * h, 0.016 * h);
    }
    builder.begin("nose", kPlain, size.kind == EntityKind::cow ? glm::vec3(0.62F, 0.45F, 0.42F) : kEye);
    addLimb(builder, glm::mix(poll, muzzle, 0.98), glm::mix(poll, muzzle, 1.08), 1.03 * form.headTo * h,
            0.85 * form.headTo * h);
}

void addHead(ModelBuilder& builder, const AnimalSize& size, const glm::vec3& coat)
{
    const double h = size.height, nose = size.middleX + 0.5 * size.length;
    const AnimalForm& form = *size.form;
    const glm::dvec3 withers(size.frontX() + 0.04 * size.length, 0.0,
                             (size.kind == EntityKind::cow ? 0.64 : 0.70) * h);
    const glm::dvec3 poll(nose - form.headLength * size.length, 0.0, form.pollZ * h),
        muzzle(nose - 0.03 * h, 0.0, form.muzzleZ * h);
    builder.begin("neck", kPlain, coat);
    addLimb(builder, withers, poll, form.neckFrom * h, form.neckTo * h);
    const glm::vec3 face = size.kind == EntityKind::sheep ? glm::vec3(0.16F, 0.14F, 0.13F) : coat;
    builder.begin("head", kPlain, face);
    addLimb(builder, poll, muzzle, form.headFrom * h, form.headTo * h);
    addFace(builder, size, poll, muzzle, face);
    if (size.kind == EntityKind::horse)
    {
        builder.begin("mane", kPlain, 0.35F * coat);
        addLimb(builder, withers + glm::dvec3(-0.02 * h, 0.0, 0.10 * h),
                poll + glm::dvec3(-0.03 * h, 0.0, 0.05 * h), 0.045 * h, 0.035 * h);
    }
    if (size.kind == EntityKind::cow)
    {
        builder.begin("horns", kPlain, kHorn);
        for (const double side : {1.0, -1.0})
            addLimb(builder, poll + glm::dvec3(0.0, side * 0.05 * h, 0.07 * h),
                    poll + glm::dvec3(0.02 * h, side * 0.14 * h, 0.14 * h), 0.018 * h, 0.008 * h);
    }
    if (size.kind == EntityKind::deer) addAntlers(builder, h, poll, h >= kPalmedFromM);
}

Model makeTrunk(const AnimalSize& size, const glm::vec3& coat)
{
    const double h = size.height, back = size.hindX() - 0.13 * size.length,
                 front = size.frontX() + 0.10 * size.length;
    const double span = front - back, w = size.thick;
    const double t = size.form->trunkHigh * h;
    ModelBuilder builder;
    builder.begin("trunk", kPlain, coat);
    addLoft(builder,
            {upright(back, 0.60 * h, 0.0, 0.0), upright(back + 0.02 * span, 0.60 * h, 0.45 * w, 0.09 * t),
             upright(back + 0.12 * span, 0.59 * h, 0.85 * w, 0.135 * t),
             upright(back + 0.30 * span, 0.58 * h, 0.92 * w, 0.135 * t),
             upright(back + 0.55 * span, 0.565 * h, w, 0.155 * t),
             upright(back + 0.80 * span, 0.585 * h, 0.92 * w, 0.175 * t),
             upright(back + 0.94 * span, 0.60 * h, 0.62 * w, 0.14 * t), upright(front, 0.60 * h, 0.0, 0.0)},
            20);
    const AnimalForm& form = *size.form;
    builder.begin("tail", kPlain, size.kind == EntityKind::horse ? 0.35F * coat : coat);
    addLimb(builder, {back + 0.03 * span, 0.0, 0.66 * h},
            {back - form.tailBack * h, 0.0, (0.66 - form.tailDrop) * h}, std::min(form.tailRadius, 0.022) * h,
            form.tailRadius * h);
    if (size.kind == EntityKind::cow) // white below and on the shoulder
    {
        builder.begin("patches", kPlain, {0.90F, 0.88F, 0.84F});
        for (const double side : {1.0, -1.0})
        {
            addLimb(builder, {back + 0.30 * span, side * 0.42 * w, 0.60 * h},
                    {back + 0.42 * span, side * 0.40 * w, 0.52 * h}, 0.56 * w, 0.60 * w);
            addLimb(builder, {back + 0.80 * span, side * 0.40 * w, 0.58 * h},
                    {back + 0.84 * span, side * 0.38 * w, 0.66 * h}, 0.58 * w, 0.40 * w);
        }
    }
    addHead(builder, size, coat);
    return builder.finish();
}

Model makeBone(double lengthM, double fromM, double toM, const glm::vec3& tint, bool hasFoot)
{
    ModelBuilder builder;
    builder.begin("bone", kPlain, tint);
    addLimb(builder, {}, {0.0, 0.0, -lengthM}, fromM, toM);
    if (hasFoot)
    {
        builder.begin("foot", kPlain, kHoof);
        addLimb(builder, {0.15 * toM, 0.0, -lengthM + 0.6 * toM}, {0.45 * toM, 0.0, -lengthM - 0.15 * toM},
                1.15 * toM, 1.25 * toM);
    }
    return builder.finish();
}

} // namespace

EntityModel makeAnimal(const EntityShape& shape)
{
    const AnimalSize size(shape);
    const glm::vec3 coat(shape.red, shape.green, shape.blue);
    EntityModel model;
    model.parts = {model.addMesh(makeTrunk(size, coat))};
    const double h = size.height, thick = size.form->legFrom;
    const glm::vec3 legs = size.kind == EntityKind::sheep ? glm::vec3(0.20F, 0.17F, 0.15F) : 0.75F * coat;
    const std::size_t upper =
        model.addMesh(makeBone(size.foreleg().upperM, thick * h, 0.5 * thick * h, coat, false));
    const std::size_t lower = model.addMesh(
        makeBone(size.foreleg().lowerM - 0.02 * h, 0.45 * thick * h, 0.29 * thick * h, legs, true));
    for (int leg = 0; leg < 4; ++leg)
        model.parts.insert(model.parts.end(), {upper, lower});
    model.pose = AnimalPose{size};
    model.eye = {shape.frontXM(), 0.0, 0.9 * shape.heightM};
    return model;
}

} // namespace scenery::models
