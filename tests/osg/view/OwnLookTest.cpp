// SPDX-License-Identifier: Apache-2.0
// What a scenario's entity looks like where its model3d is the look of a vehicle.
#include <gtest/gtest.h>

#include <osg/ComputeBoundsVisitor>

#include "TestFolder.h"
#include "scene/EntityModel.h"
#include "scenery/nodes/EntityLook.h"

namespace
{

const char* const kTall = R"({"name": "tall red-nosed car", "like": "saloon", "colours": [[0.1, 0.2, 0.9]],
 "size": {"lengthM": 4.5, "widthM": 1.8, "heightM": 1.9}, "bounds": {"heightM": [1.8, 2.1], "radiusM": 2.7},
 "profile": {"top": [-2.25, 1.7, -2.2, 1.88, 0.4, 1.9, 1.2, 1.2, 2.25, 0.7], "belt": [-2.25, 0.9, 2.25, 0.6]}})";

class OwnLook : public testing::Test
{
protected:
    /// A car of 4.6 m whose model3d is a file of the folder, or empty.
    simulation::ScenarioObject driven(const std::string& look) const
    {
        simulation::Vehicle car;
        car.name = "mid-size car";
        car.category = "car";
        car.box = {{1.35, 0.0, 0.715}, 4.6, 1.78, 1.43};
        car.frontAxle = simulation::Axle{0.6, 0.63, 1.54, 2.7, 0.316};
        car.rearAxle = {0.0, 0.63, 1.54, 0.0, 0.316};
        if (!look.empty()) car.model3d = look;
        return {{}, "Ego", car};
    }

    foundation::Result<trainer::EntityModel> made(const simulation::ScenarioObject& object)
    {
        return trainer::EntityModel::create(object, _folder / "", _shapes);
    }

    testsupport::TestFolder _folder{"own-look-shown"};
    scenery::EntityShapes _shapes;
};

/// How high the vehicle is drawn. Units: metres.
double drawnHeightM(const trainer::EntityModel& model)
{
    osg::ComputeBoundsVisitor bounds;
    model.node()->accept(bounds);
    return bounds.getBoundingBox().zMax();
}

} // namespace

TEST_F(OwnLook, ACarIsDrawnAsTheFileSaysThatItsFileNames)
{
    _folder.write("tall.json", kTall);
    const auto plain = made(driven("")), own = made(driven("tall.json"));
    ASSERT_TRUE(plain);
    ASSERT_TRUE(own) << own.error().message();
    EXPECT_EQ(plain->shape().look, nullptr);
    ASSERT_NE(own->shape().look, nullptr);
    EXPECT_EQ(own->shape().look->name, "tall red-nosed car");
    EXPECT_TRUE(own->notes().empty());
    // The size is the vehicle's; the shape within it is the look's: a straight roof to the very back.
    EXPECT_DOUBLE_EQ(own->shape().heightM, plain->shape().heightM);
    EXPECT_NE(scenery::models::makeEntityModel(own->shape()).meshes[0].mesh.positions,
              scenery::models::makeEntityModel(plain->shape()).meshes[0].mesh.positions);
    EXPECT_NEAR(drawnHeightM(*own), own->shape().heightM, 0.1 * own->shape().heightM);
}

TEST_F(OwnLook, ColoursAreThoseOfTheLookUnlessANameSaysAnother)
{
    const std::string file = _folder.write("tall.json", kTall);
    simulation::Vehicle vehicle;
    vehicle.category = "car";
    vehicle.model3d = file;
    simulation::ScenarioObject object{{}, "Somebody", vehicle};
    const auto look = _shapes.lookIn(file);
    ASSERT_TRUE(look) << look.error().message();
    EXPECT_FLOAT_EQ(scenery::entityLook(object, *look).shape.red, 0.72F)
        << "the look's name has the word red";
    auto plain = **look;
    plain.name = "tall car";
    const auto other = std::make_shared<const scenery::models::VehicleLook>(plain);
    EXPECT_FLOAT_EQ(scenery::entityLook(object, other).shape.blue, 0.9F);
    EXPECT_FLOAT_EQ(scenery::entityLook(object, other).shape.lengthM, 4.5)
        << "without a box, the look's size";
    EXPECT_FLOAT_EQ(scenery::entityLook(object, other).shape.heightM, 1.9);
    object.name = "white one";
    EXPECT_FLOAT_EQ(scenery::entityLook(object, other).shape.blue, 0.92F);
}

TEST_F(OwnLook, EntitiesOfOneFileShareOneModel)
{
    const std::string file = _folder.write("tall.json", kTall);
    const auto look = _shapes.lookIn(file), again = _shapes.lookIn(_folder / "here/../tall.json");
    ASSERT_TRUE(look && again);
    EXPECT_EQ(*look, *again);
    scenery::models::EntityShape shape;
    shape.kind = scenery::models::EntityKind::car;
    shape.lengthM = 4.5;
    shape.look = *look;
    EXPECT_EQ(_shapes.of(shape), _shapes.of(shape));
}

TEST_F(OwnLook, AFaultyFileIsAnErrorAndAMissingOneANote)
{
    const auto missing = made(driven("none.json"));
    ASSERT_TRUE(missing);
    ASSERT_EQ(missing->notes().size(), 1U);
    EXPECT_NE(missing->notes()[0].find("none.json"), std::string::npos);
    _folder.write("bad.json", R"({"name": "x", "like": "saloon", "colour": [1, 0, 0]})");
    const auto bad = made(driven("bad.json"));
    ASSERT_FALSE(bad);
    EXPECT_NE(bad.error().message().find("bad.json: /colour"), std::string::npos) << bad.error().message();
}
