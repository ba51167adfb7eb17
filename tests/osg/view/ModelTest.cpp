// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/ComputeBoundsVisitor>
#include <osg/TriangleFunctor>

#include "scenery/nodes/AircraftModel.h"
#include "scenery/nodes/CarModel.h"
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

TEST(CarModel, HasTheSizeItSaysAndStandsOnTheGround)
{
    const scenery::CarModel car;
    const osg::BoundingBox box = boundsOf(car.node());
    EXPECT_NEAR(box.zMin(), 0.0, 0.02);
    EXPECT_NEAR(box.zMax(), 1.46, 0.02);
    // The contact shadow's rim reaches half a metre beyond.
    EXPECT_NEAR(box.xMax(), 3.55, 0.65);
    EXPECT_NEAR(box.xMin(), -0.87, 0.65);
}

TEST(CarModel, MovesWithItsStateAndItsWheelsTravel)
{
    scenery::CarModel car;
    simulation::EntityState state;
    state.position = {1000.0, 2000.0, 300.0};
    car.setState(state);
    EXPECT_NEAR(boundsOf(car.node()).zMin(), 300.0, 0.02);
    state.wheelTravelM = {0.0, 0.0, 0.0, -0.1};
    car.setState(state);
    EXPECT_NEAR(boundsOf(car.node()).zMin(), 299.9, 0.02);
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
