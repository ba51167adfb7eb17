// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/EntityModel.h"

#include <set>

#include <gtest/gtest.h>

#include "scenery/models/ModelCheck.h"
#include "scenery/models/entities/DefaultSize.h"
#include "scenery/models/entities/Gait.h"
#include "scenery/models/entities/LegBend.h"

namespace models = scenery::models;
using models::EntityKind;
using models::EntityModel;
using models::EntityMotion;
using models::EntityShape;

namespace
{

EntityShape usual(EntityKind kind)
{
    EntityShape shape;
    shape.kind = kind;
    models::setDefaultSize(shape);
    return shape;
}

struct Bounds
{
    glm::dvec3 low{1e300}, high{-1e300};
};

Bounds boundsOf(const EntityModel& model, const EntityMotion& motion)
{
    Bounds bounds;
    const auto pose = model.pose(motion);
    for (std::size_t part = 0; part < model.parts.size(); ++part)
        for (const glm::dvec3& p : model.meshes[model.parts[part]].mesh.positions)
        {
            const glm::dvec3 at(pose[part] * glm::dvec4(p, 1.0));
            bounds.low = glm::min(bounds.low, at);
            bounds.high = glm::max(bounds.high, at);
        }
    return bounds;
}

constexpr std::array kKinds{EntityKind::car,        EntityKind::van,           EntityKind::bus,
                            EntityKind::lorry,      EntityKind::tractor,       EntityKind::semitrailer,
                            EntityKind::trailer,    EntityKind::motorbike,     EntityKind::bicycle,
                            EntityKind::pedestrian, EntityKind::wheelchair,    EntityKind::horse,
                            EntityKind::cow,        EntityKind::sheep,         EntityKind::deer,
                            EntityKind::dog,        EntityKind::lightAircraft, EntityKind::glider,
                            EntityKind::airliner,   EntityKind::helicopter,    EntityKind::ship,
                            EntityKind::cone,       EntityKind::barrier,       EntityKind::pole,
                            EntityKind::box};

/// Returns the place of an ankle of a walker in the world: its part's origin.
glm::dvec3 ankleOf(const EntityModel& walker, std::size_t shoe, const EntityMotion& motion)
{
    return glm::dvec3(walker.pose(motion)[shoe][3]) + glm::dvec3(motion.odometerM, 0.0, 0.0);
}

/// Returns how far the standing left foot slides while a walker covers half a stride of `strideM`.
double slideOf(const EntityModel& walker, double strideM)
{
    constexpr std::size_t kLeftShoe = 3;
    double least = 1e300, most = -1e300;
    for (int i = 0; i <= 20; ++i)
    {
        EntityMotion motion;
        motion.speedMps = 1.4;
        motion.odometerM = 0.4999 * strideM * i / 20.0;
        const double x = ankleOf(walker, kLeftShoe, motion).x;
        least = std::min(least, x);
        most = std::max(most, x);
    }
    return most - least;
}

} // namespace

TEST(EntityModel, EveryKindIsSoundStandsOnTheGroundAndFillsItsBox)
{
    for (const EntityKind kind : kKinds)
    {
        SCOPED_TRACE(static_cast<int>(kind));
        const EntityShape shape = usual(kind);
        ASSERT_TRUE(models::isPlausible(shape));
        const EntityModel model = models::makeEntityModel(shape);
        for (const models::Model& mesh : model.meshes)
            EXPECT_EQ(models::defectOf(mesh), "");
        ASSERT_EQ(model.pose({}).size(), model.parts.size());
        const Bounds bounds = boundsOf(model, {});
        const double below = kind == EntityKind::pole   ? 1.0
                             : kind == EntityKind::ship ? 4.0
                                                        : 0.03; // a foot in the ground, a draught
        EXPECT_NEAR(bounds.low.z, 0.0, below);
        EXPECT_NEAR(bounds.high.z, shape.heightM, 0.15 * shape.heightM);
        if (kind == EntityKind::pedestrian || kind == EntityKind::pole || kind == EntityKind::helicopter)
            continue; // not as long as wide; a rotor reaches beyond
        EXPECT_NEAR(bounds.high.x, shape.frontXM(), 0.12 + 0.1 * shape.lengthM);
        EXPECT_NEAR(bounds.low.x, shape.backXM(), 0.12 + 0.1 * shape.lengthM);
    }
}

TEST(EntityModel, EqualShapesGiveTheSameBytes)
{
    const EntityModel a = models::makeEntityModel(usual(EntityKind::lorry)),
                      b = models::makeEntityModel(usual(EntityKind::lorry));
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i)
        EXPECT_EQ(a.meshes[i].mesh.positions, b.meshes[i].mesh.positions);
}

TEST(EntityModel, LampsOfEachKindLieOnTheBody)
{
    using Lamp = models::EntityLamp::Kind;
    for (const EntityKind kind : {EntityKind::car, EntityKind::van, EntityKind::bus})
    {
        SCOPED_TRACE(static_cast<int>(kind));
        const EntityShape shape = usual(kind);
        const EntityModel model = models::makeEntityModel(shape);
        std::set<std::pair<Lamp, bool>> found; // with the end of the vehicle
        for (const models::EntityLamp& lamp : model.lamps)
        {
            found.emplace(lamp.kind, lamp.looksAhead);
            EXPECT_LE(std::abs(lamp.middle.y) + 0.5 * lamp.widthM, 0.5 * shape.widthM + 0.04);
            EXPECT_LE(std::abs(lamp.sweepM), 4.5 * lamp.widthM) << "a lamp that runs along the side";
            EXPECT_GE(lamp.looksAhead ? lamp.middle.x - shape.middleXM : shape.middleXM - lamp.middle.x,
                      0.4 * shape.lengthM);
        }
        for (const auto& [lamp, isAhead] : {std::pair{Lamp::head, true},
                                            {Lamp::tail, false},
                                            {Lamp::brake, false},
                                            {Lamp::indicatorLeft, true},
                                            {Lamp::indicatorRight, true},
                                            {Lamp::indicatorLeft, false},
                                            {Lamp::indicatorRight, false}})
            EXPECT_TRUE(found.contains({lamp, isAhead})) << static_cast<int>(lamp);
    }
}

TEST(EntityModel, AStandingFootStaysWhereItIs)
{
    const EntityShape shape = usual(EntityKind::pedestrian);
    const EntityModel walker = models::makeEntityModel(shape);
    const double strideM = 0.72 * shape.heightM;
    EXPECT_LT(slideOf(walker, strideM), 0.02);
    EXPECT_GT(slideOf(walker, 1.2 * strideM), 0.05) << "a foot that slides must be found";
}

TEST(EntityModel, AWalkerThatStopsStandsWithBothFeetOnTheGround)
{
    const EntityModel walker = models::makeEntityModel(usual(EntityKind::pedestrian));
    for (const double odometerM : {0.0, 0.4, 0.8})
    {
        EntityMotion motion;
        motion.odometerM = odometerM;
        const glm::dvec3 left = ankleOf(walker, 3, motion), right = ankleOf(walker, 7, motion);
        EXPECT_NEAR(left.x, right.x, 0.01);
        EXPECT_NEAR(left.z, right.z, 0.01);
        EXPECT_NEAR(boundsOf(walker, motion).low.z, 0.0, 0.02);
    }
}

TEST(EntityModel, WheelsRollSteerAndSpring)
{
    const EntityShape shape = usual(EntityKind::car);
    const EntityModel car = models::makeEntityModel(shape);
    EntityMotion motion;
    motion.odometerM = 0.25 * 2.0 * 3.14159265358979 * shape.axles[0].wheelRadiusM; // a quarter of a turn
    motion.steeringRad = 0.3;
    motion.wheelTravelM = {0.0, 0.05, 0.0, 0.0};
    const auto pose = car.pose(motion), before = car.pose({});
    const auto turned = [](const glm::dmat4& matrix, const glm::dvec3& v)
    { return glm::dvec3(matrix * glm::dvec4(v, 0.0)); };
    const glm::dvec3 down = turned(pose[3], {1.0, 0.0, 0.0}); // rear left: what looked ahead looks down
    EXPECT_NEAR(down.z, -1.0, 1e-9);
    const glm::dvec3 axle = turned(pose[1], {0.0, 1.0, 0.0}); // front left
    EXPECT_NEAR(axle.x, -std::sin(0.3), 1e-9);
    EXPECT_NEAR(pose[2][3].z - before[2][3].z, 0.05, 1e-12);
    EXPECT_NEAR(turned(pose[3], {0.0, 1.0, 0.0}).y, 1.0, 1e-9);
}

TEST(EntityModel, ABoxThatCannotBeOfItsKindIsNotPlausible)
{
    EntityShape bus = usual(EntityKind::bus);
    EXPECT_TRUE(models::isPlausible(bus));
    bus.heightM = 1.5;
    EXPECT_FALSE(models::isPlausible(bus));
}

TEST(LegBend, KneeAndAnkleAreAsWorkedByHand)
{
    // Bones of 0.5 m, target 0.8 m below the hip: cos = 0.64 / (2 * 0.5 * 0.8) = 0.8, so the knee is 0.3 m
    // ahead, 0.4 m down.
    const models::LegBend bend = models::bendLeg({0.5, 0.5, true}, {0.0, 0.1, 1.0}, {0.0, 0.1, 0.2});
    EXPECT_NEAR(bend.joint.x, 0.3, 1e-12);
    EXPECT_NEAR(bend.joint.z, 0.6, 1e-12);
    EXPECT_NEAR(bend.end.z, 0.2, 1e-12);
    EXPECT_NEAR(models::bendLeg({0.5, 0.5, false}, {0.0, 0.1, 1.0}, {0.0, 0.1, 0.2}).joint.x, -0.3, 1e-12);
    // A target out of reach is looked at.
    EXPECT_NEAR(models::bendLeg({0.5, 0.5, true}, {0.0, 0.0, 1.0}, {3.0, 0.0, 1.0}).end.x, 0.999, 1e-9);
}
