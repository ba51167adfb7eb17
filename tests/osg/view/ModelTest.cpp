// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/ComputeBoundsVisitor>
#include <osg/TriangleFunctor>

#include "RenderedDefaultCar.h"
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
    const DefaultCar car;
    const osg::BoundingBox box = boundsOf(car.node());
    EXPECT_NEAR(box.zMin(), 0.0, 0.03);
    EXPECT_NEAR(box.zMax(), DefaultCar::shape().heightM, 0.03);
    // The contact shadow's rim reaches half a metre beyond.
    EXPECT_NEAR(box.xMax(), DefaultCar::shape().frontXM(), 0.65);
    EXPECT_NEAR(box.xMin(), DefaultCar::shape().backXM(), 0.65);
}

TEST(EntityNode, MovesWithItsStateAndItsWheelsTravel)
{
    DefaultCar car;
    simulation::EntityState state;
    state.position = {1000.0, 2000.0, 300.0};
    car.setState(state);
    EXPECT_NEAR(boundsOf(car.node()).zMin(), 300.0, 0.03);
    state.wheelTravelM = {0.0, 0.0, 0.0, -0.1};
    car.setState(state);
    EXPECT_NEAR(boundsOf(car.node()).zMin(), 299.9, 0.03);
}

TEST(EntityLamps, DefaultOnesFollowBrakingReversingAndDusk)
{
    using Kind = scenery::models::EntityLamp::Kind;
    const auto isLit = [](const simulation::EntityState& state, bool isDark, Kind kind)
    { return scenery::defaultLamps(state, isDark)[static_cast<std::size_t>(kind)]; };
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

TEST(EntityLamps, OfAnAircraftAreOnAsItsPartsSayAndStrobesFlash)
{
    using Kind = scenery::models::EntityLamp::Kind;
    simulation::EntityState state;
    state.aircraft.emplace().hasNavigationLights = true;
    const auto isLit = [&](Kind kind, double timeS)
    { return scenery::defaultLamps(state, true, timeS)[static_cast<std::size_t>(kind)]; };
    EXPECT_TRUE(isLit(Kind::navigationRed, 0.0) && isLit(Kind::navigationGreen, 0.0) &&
                isLit(Kind::navigationWhite, 0.0));
    EXPECT_FALSE(isLit(Kind::strobe, 0.05) || isLit(Kind::landing, 0.0) || isLit(Kind::beacon, 0.5));
    state.aircraft->hasStrobes = state.aircraft->hasBeacon = state.aircraft->hasLandingLight = true;
    EXPECT_TRUE(isLit(Kind::landing, 0.3));
    int strobes = 0, beacons = 0;
    for (int frame = 0; frame < 24 * 6; ++frame) // five periods of the one, six of the other
    {
        strobes += isLit(Kind::strobe, frame / 24.0) ? 1 : 0;
        beacons += isLit(Kind::beacon, frame / 24.0) ? 1 : 0;
    }
    EXPECT_NEAR(strobes, 5 * 2.4, 3.0);
    EXPECT_NEAR(beacons, 6 * 4.8, 3.0);
}

TEST(EntityNode, EqualShapesShareTheirMeshes)
{
    scenery::EntityShapes shapes;
    EXPECT_EQ(shapes.of(DefaultCar::shape()), shapes.of(DefaultCar::shape()));
    scenery::models::EntityShape other = DefaultCar::shape();
    other.blue = 0.5F;
    EXPECT_NE(shapes.of(other), shapes.of(DefaultCar::shape()));
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
