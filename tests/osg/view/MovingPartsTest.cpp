// SPDX-License-Identifier: Apache-2.0
// The parts of vehicles as nodes, against the state they are shown for.
#include <cmath>

#include <gtest/gtest.h>

#include <osg/NodeVisitor>

#include "RenderedDefaultCar.h"

namespace
{

using scenery::models::EntityKind;

/// The transforms with a name below a node.
class Named : public osg::NodeVisitor
{
public:
    explicit Named(std::string name) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _name(std::move(name))
    {
        setNodeMaskOverride(~0U);
    }

    void apply(osg::MatrixTransform& node) override
    {
        if (node.getName() == _name) found.push_back(&node);
        traverse(node);
    }

    std::vector<osg::MatrixTransform*> found;

private:
    std::string _name;
};

scenery::models::EntityShape defaultShape(EntityKind kind)
{
    scenery::models::EntityShape shape;
    shape.kind = kind;
    scenery::models::setDefaultSize(shape);
    return shape;
}

/// An entity of usual size.
struct Shown
{
    explicit Shown(EntityKind kind) : entity(defaultShape(kind), shapes) {}

    osg::MatrixTransform& part(const std::string& name, std::size_t index = 0)
    {
        Named named(name);
        entity.node()->accept(named);
        EXPECT_GT(named.found.size(), index) << name;
        return *named.found.at(index);
    }

    void show(const simulation::AircraftParts& parts)
    {
        simulation::EntityState state;
        state.aircraft = parts;
        entity.setState(state, {});
    }

    scenery::EntityShapes shapes;
    scenery::EntityNode entity;
};

/// How far a part has turned about its hinge: above 0 if its trailing edge goes down, or to the left.
double trailingEdgeDeg(const osg::MatrixTransform& part, bool isSideways)
{
    const osg::Vec3d back = osg::Matrixd::transform3x3(osg::Vec3d(-1.0, 0.0, 0.0), part.getMatrix());
    double angle = 0.0;
    osg::Vec3d axis;
    part.getMatrix().getRotate().getRotate(angle, axis);
    const double turned = std::abs(osg::RadiansToDegrees(std::remainder(angle, 2.0 * osg::PI)));
    return std::copysign(turned, isSideways ? back.y() : -back.z());
}

simulation::AircraftParts deflected()
{
    simulation::AircraftParts parts;
    parts.elevatorDeg = -12.0;
    parts.leftAileronDeg = 14.0;
    parts.rightAileronDeg = -19.0;
    parts.rudderDeg = 16.0;
    parts.flapDeg = 20.0;
    return parts;
}

} // namespace

TEST(MovingParts, SurfacesOfAnAircraftStandAsItsStateSays)
{
    constexpr double kAllowedDeg = 1e-6;
    for (const EntityKind kind : {EntityKind::lightAircraft, EntityKind::airliner, EntityKind::glider})
    {
        SCOPED_TRACE(static_cast<int>(kind));
        Shown shown(kind);
        shown.show(deflected());
        for (const std::size_t side : {0U, 1U})
            EXPECT_NEAR(trailingEdgeDeg(shown.part("elevator", side), false), -12.0, kAllowedDeg);
        EXPECT_NEAR(trailingEdgeDeg(shown.part("left aileron"), false), 14.0, kAllowedDeg);
        EXPECT_NEAR(trailingEdgeDeg(shown.part("right aileron"), false), -19.0, kAllowedDeg);
        EXPECT_NEAR(trailingEdgeDeg(shown.part("rudder"), true), 16.0, kAllowedDeg);
        if (kind == EntityKind::glider) continue; // without flaps
        EXPECT_NEAR(trailingEdgeDeg(shown.part("left flap"), false), 20.0, kAllowedDeg);
        EXPECT_NEAR(trailingEdgeDeg(shown.part("right flap"), false), 20.0, kAllowedDeg);
    }
}

TEST(MovingParts, ASurfaceThatTurnsTheOtherWayIsFound)
{
    Shown shown(EntityKind::lightAircraft);
    simulation::AircraftParts parts = deflected();
    std::swap(parts.leftAileronDeg, parts.rightAileronDeg); // the mutation
    shown.show(parts);
    EXPECT_GT(std::abs(trailingEdgeDeg(shown.part("left aileron"), false) - 14.0), 20.0);
}

TEST(MovingParts, AHingeStaysWhereItIs)
{
    Shown shown(EntityKind::lightAircraft);
    shown.show({});
    const osg::Matrixd before = shown.part("left aileron").getMatrix();
    shown.show(deflected());
    const osg::Matrixd after = shown.part("left aileron").getMatrix();
    const osg::Vec3d hinge(0.95 - 0.72 * 1.62, 2.6,
                           2.13); // the share of the chord at the wing's middle station
    EXPECT_LT((hinge * after - hinge * before).length(), 1e-9);
    const osg::Vec3d edge(0.95 - 1.62, 2.6, 2.13);
    EXPECT_GT((edge * after - edge * before).length(), 0.1);
}

TEST(MovingParts, LegsFollowTheirStrutsAndTheNoseWheelSteers)
{
    Shown shown(EntityKind::lightAircraft);
    simulation::AircraftParts parts;
    parts.wheelBottom = {glm::dvec3(1.65, 0.0, -0.1), glm::dvec3(0.0, 1.1, 0.0), glm::dvec3(0.0, -1.1, 0.0)};
    parts.strutM = {0.15, 0.06, 0.04};
    parts.noseSteeringDeg = 10.0;
    parts.wheelTurnDeg = {0.0, 90.0, 0.0};
    shown.show(parts);
    const std::array<osg::Vec3d, 3> built{{{1.70, 0.0, 0.0}, {0.0, 1.26, 0.0}, {0.0, -1.26, 0.0}}};
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
        const osg::Vec3d bottom = built[leg] * shown.part("leg " + std::to_string(leg)).getMatrix();
        EXPECT_NEAR(bottom.x(), parts.wheelBottom[leg].x, 1e-9);
        EXPECT_NEAR(bottom.y(), parts.wheelBottom[leg].y, 1e-9);
        EXPECT_NEAR(bottom.z(), parts.wheelBottom[leg].z + parts.strutM[leg], 1e-9)
            << "a strut that is not pressed";
    }
    const auto turned = [&](const char* name, const osg::Vec3d& v)
    { return osg::Matrixd::transform3x3(v, shown.part(name).getMatrix()); };
    const osg::Vec3d ahead = turned("leg 0", {1.0, 0.0, 0.0});
    EXPECT_NEAR(osg::RadiansToDegrees(std::atan2(ahead.y(), ahead.x())), 10.0, 1e-9);
    EXPECT_NEAR(turned("leg 1", {1.0, 0.0, 0.0}).y(), 0.0, 1e-12) << "main wheels do not steer";
    EXPECT_NEAR(turned("wheel 1", {1.0, 0.0, 0.0}).z(), -1.0, 1e-9) << "what looked ahead looks down";
}

TEST(MovingParts, APropellerStandsTurnsAndBecomesADisc)
{
    for (const EntityKind kind : {EntityKind::lightAircraft, EntityKind::helicopter})
    {
        Shown shown(kind);
        simulation::AircraftParts parts;
        parts.propellerTurnDeg = 40.0;
        shown.show(parts);
        osg::MatrixTransform& blades = shown.part("rotor");
        osg::Node* const disc =
            shown.entity.node()->asGroup()->getChild(shown.entity.node()->asGroup()->getNumChildren() - 1 -
                                                     (kind == EntityKind::helicopter ? 1U : 0U));
        ASSERT_EQ(disc->getName(), "rotor disc");
        EXPECT_NE(blades.getNodeMask(), 0U);
        EXPECT_EQ(disc->getNodeMask(), 0U) << "blades that stand are seen";
        osg::Quat turn = blades.getMatrix().getRotate();
        double angle = 0.0;
        osg::Vec3d axis;
        turn.getRotate(angle, axis);
        EXPECT_NEAR(osg::RadiansToDegrees(angle), 40.0, 1e-6);
        EXPECT_NEAR(kind == EntityKind::helicopter ? axis.z() : axis.x(), 1.0, 1e-9);
        parts.propellerRadps = 240.0;
        shown.show(parts);
        EXPECT_EQ(blades.getNodeMask(), 0U);
        EXPECT_NE(disc->getNodeMask(), 0U);
    }
}

TEST(MovingParts, WheelsOfACarTurnByTheirOwnPhysicsWhereItSays)
{
    DefaultCar car;
    simulation::EntityState state;
    state.odometerM = 0.25 * 2.0 * osg::PI * DefaultCar::shape().axles[0].wheelRadiusM; // a quarter of a turn
    state.steeringDeg = 20.0;
    const auto part = [&](const char* name) -> osg::MatrixTransform&
    {
        Named named(name);
        car.node()->accept(named);
        return *named.found.at(0);
    };
    const auto turned = [&](const char* name, const osg::Vec3d& v)
    { return osg::Matrixd::transform3x3(v, part(name).getMatrix()); };
    car.setState(state);
    EXPECT_NEAR(turned("wheel 1 left", {1.0, 0.0, 0.0}).z(), -1.0, 1e-9);
    const osg::Vec3d axle = turned("wheel 0 left", {0.0, 1.0, 0.0});
    EXPECT_NEAR(osg::RadiansToDegrees(std::atan2(-axle.x(), axle.y())), 20.0, 1e-9);
    state.wheelTurnDeg = {{0.0, 0.0, 180.0, 0.0}}; // locked in front, spinning behind
    car.setState(state);
    EXPECT_NEAR(turned("wheel 1 left", {1.0, 0.0, 0.0}).x(), -1.0, 1e-9);
    EXPECT_NEAR(turned("wheel 1 right", {1.0, 0.0, 0.0}).z(), 0.0, 1e-9) << "not the odometer's";
}
