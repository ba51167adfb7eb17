// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/ComputeBoundsVisitor>
#include <osg/TriangleFunctor>

#include "RenderedUsualCar.h"
#include "scenery/nodes/AircraftModel.h"
#include "scenery/nodes/ModelMesh.h"

namespace
{

osg::BoundingBox boundsOf(osg::Node* node)
{
    osg::ComputeBoundsVisitor visitor;
    node->accept(visitor);
    return visitor.getBoundingBox();
}

/// Signed volume of a closed surface: positive when its triangles look outwards.
struct VolumeSum
{
    double volume = 0.0;
    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        volume += static_cast<double>(a * (b ^ c)) / 6.0;
    }
};

double volumeOf(const scenery::ModelMesh& mesh)
{
    osg::TriangleFunctor<VolumeSum> sum;
    mesh.geometry()->accept(sum);
    return sum.volume;
}

} // namespace

TEST(EntityNode, HasTheSizeOfItsShapeAndStandsOnTheGround)
{
    const UsualCar car;
    const osg::BoundingBox box = boundsOf(car.node());
    EXPECT_NEAR(box.zMin(), 0.0, 0.03);
    EXPECT_NEAR(box.zMax(), UsualCar::shape().heightM, 0.03);
    // The contact shadow's rim reaches half a metre beyond.
    EXPECT_NEAR(box.xMax(), UsualCar::shape().frontXM(), 0.65);
    EXPECT_NEAR(box.xMin(), UsualCar::shape().backXM(), 0.65);
}

TEST(EntityNode, MovesWithItsStateAndItsWheelsTravel)
{
    UsualCar car;
    simulation::EntityState state;
    state.position = {1000.0, 2000.0, 300.0};
    car.setState(state);
    EXPECT_NEAR(boundsOf(car.node()).zMin(), 300.0, 0.03);
    state.wheelTravelM = {0.0, 0.0, 0.0, -0.1};
    car.setState(state);
    EXPECT_NEAR(boundsOf(car.node()).zMin(), 299.9, 0.03);
}

TEST(EntityLamps, UsualOnesFollowBrakingReversingAndDusk)
{
    using Kind = scenery::models::EntityLamp::Kind;
    const auto isLit = [](const simulation::EntityState& state, bool isDark, Kind kind)
    { return scenery::usualLamps(state, isDark)[static_cast<std::size_t>(kind)]; };
    simulation::EntityState state;
    state.headingDeg = 90.0;
    state.speedMps = 10.0;
    EXPECT_FALSE(isLit(state, false, Kind::brake));
    state.acceleration = {0.0, -2.0, 0.0};
    EXPECT_TRUE(isLit(state, false, Kind::brake));
    state.acceleration = {-2.0, 0.0, 0.0}; // in a bend, not braking
    EXPECT_FALSE(isLit(state, false, Kind::brake));
    state.speedMps = -1.0;
    EXPECT_TRUE(isLit(state, false, Kind::reversing));
    EXPECT_FALSE(isLit(state, false, Kind::head));
    EXPECT_TRUE(isLit(state, true, Kind::head));
}

TEST(EntityNode, EqualShapesShareTheirMeshes)
{
    scenery::EntityShapes shapes;
    EXPECT_EQ(shapes.of(UsualCar::shape()), shapes.of(UsualCar::shape()));
    scenery::models::EntityShape other = UsualCar::shape();
    other.blue = 0.5F;
    EXPECT_NE(shapes.of(other), shapes.of(UsualCar::shape()));
}

TEST(AircraftModel, HasTheSizeItSaysAndStandsOnItsWheels)
{
    const osg::BoundingBox box = boundsOf(scenery::makeLightAircraft());
    EXPECT_NEAR(box.zMin(), 0.0, 0.02);
    EXPECT_NEAR(box.zMax(), 2.75, 0.06);
    EXPECT_NEAR(box.yMax() - box.yMin(), 11.0, 0.1);
    EXPECT_NEAR(box.xMax() - box.xMin(), 8.1, 0.3);
    EXPECT_TRUE(box.contains(osg::Vec3d(scenery::pilotEyeInAircraft().x, scenery::pilotEyeInAircraft().y,
                                        scenery::pilotEyeInAircraft().z)));
}

TEST(AircraftModel, PutsItsWheelsWhereTheirStrutsAre)
{
    const osg::ref_ptr<osg::Group> aircraft = scenery::makeLightAircraft();
    simulation::AircraftParts parts;
    parts.wheelBottom = {glm::dvec3(1.65, 0.0, -0.1), glm::dvec3(0.0, 1.1, 0.0), glm::dvec3(0.0, -1.1, 0.0)};
    scenery::showAircraftParts(*aircraft, parts);
    EXPECT_NEAR(boundsOf(aircraft).zMin(), -0.1, 0.005);
    parts.strutM = {0.15, 0.06, 0.04};
    scenery::showAircraftParts(*aircraft, parts);
    EXPECT_NEAR(boundsOf(aircraft).zMin(), 0.04, 0.005); // that of the right wheel
}

TEST(ModelMesh, FacesLookOutwardsAndMirroringKeepsThemSo)
{
    scenery::ModelMesh mesh;
    mesh.addBox({1.0F, 1.0F, 1.0F}, {2.0F, 3.0F, 4.0F}, {1.0F, 1.0F, 1.0F, 1.0F});
    EXPECT_NEAR(volumeOf(mesh), 6.0, 1e-4);
    mesh.mirrorSince(0);
    EXPECT_NEAR(volumeOf(mesh), 12.0, 1e-4);
}

TEST(ModelMesh, ATurnedBodyIsClosed)
{
    scenery::ModelMesh mesh;
    mesh.addTurned({{5.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {{0.0F, 0.5F}, {2.0F, 0.5F}}, 64},
                   {1.0F, 1.0F, 1.0F, 1.0F});
    EXPECT_NEAR(volumeOf(mesh), 3.14159 * 0.25 * 2.0, 0.01);
}
