// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "RenderedPicture.h"
#include "RenderedView.h"
#include "scenery/nodes/AirfieldNode.h"

namespace
{

constexpr double kAwayM = 400.0;

osg::ref_ptr<osg::Image> pictureAt(const std::vector<scenery::PapiUnit>& units, double elevationDeg,
                                   bool isLit = true)
{
    osgOffscreen::OffscreenSettings settings;
    settings.backend = osgOffscreen::defaultBackend();
    settings.widthPx = 480;
    settings.heightPx = 270;
    settings.samples = 4;
    const rendered::ViewScene scene;
    scenery::LightUniforms uniforms(*scene.root->getStateSet());
    scenery::LightLevels levels{};
    levels[static_cast<std::size_t>(scenery::LightGroup::papi)] = isLit ? 1.0F : 0.0F;
    uniforms.show(1e-4, 0.0, 0.0, levels);
    scenery::AirfieldNode node(units, {});
    node.light(levels);
    scene.root->addChild(node.node());
    const double up = kAwayM * std::tan(elevationDeg * 3.14159265358979 / 180.0);
    return rendered::pictureFrom(scene.root,
                                 scenery::poseLookingAt({-kAwayM, 0.0, up + 5.5}, {0.0, 0.0, 5.5}), settings);
}

/// How many of the four lights are white: by the pixels that a picture with lights has brighter than one
/// without.
double whites(std::vector<scenery::PapiUnit> units, double elevationDeg)
{
    for (scenery::PapiUnit& unit : units)
        unit.place.z = 5.0; // the lamps shine half a metre above
    const auto with = pictureAt(units, elevationDeg), without = pictureAt(units, elevationDeg, false);
    double white = 0.0, red = 0.0;
    for (int y = 0; y < with->t(); ++y)
        for (int x = 0; x < with->s(); ++x)
        {
            const auto* a = with->data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            const auto* b = without->data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            if (a[0] - b[0] < 40) continue;
            (2 * (a[1] - b[1]) > a[0] - b[0] ? white : red) += 1.0;
        }
    EXPECT_GT(white + red, 7.0) << "no light is seen at " << elevationDeg;
    return 4.0 * white / std::max(white + red, 1.0);
}

/// Units at the scene's zero, for aircraft that come from -x.
std::vector<scenery::PapiUnit> unitsHere()
{
    return scenery::papiUnits({-300.0, -43.5}, {1.0, 0.0}, 1500.0, 30.0);
}

} // namespace

TEST(Papi, StandsLeftOfTheRunwayBesideItsAimingPoint)
{
    const auto units = unitsHere();
    ASSERT_EQ(units.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
    {
        EXPECT_NEAR(units[i].place.x, 0.0, 1e-9) << "300 m behind the threshold";
        EXPECT_NEAR(units[i].place.y, -43.5 + 15.0 + 15.0 + 9.0 * static_cast<double>(i), 1e-9);
    }
    EXPECT_NEAR(units.front().angleDeg, 3.5, 1e-9);
    EXPECT_NEAR(units.back().angleDeg, 2.5, 1e-9) << "the outermost is the lowest";
}

TEST(Papi, ItsColoursTellTheAngle)
{
    EXPECT_NEAR(whites(unitsHere(), 2.3), 0.0, 0.35);
    EXPECT_NEAR(whites(unitsHere(), 2.67), 1.0, 0.5);
    EXPECT_NEAR(whites(unitsHere(), 3.0), 2.0, 0.5);
    EXPECT_NEAR(whites(unitsHere(), 3.33), 3.0, 0.5);
    EXPECT_NEAR(whites(unitsHere(), 3.8), 4.0, 0.35);
    auto steeper = unitsHere(); // set wrong, they show it
    for (auto& unit : steeper)
        unit.angleDeg += 0.5;
    EXPECT_LT(whites(steeper, 3.0), 1.5);
}

TEST(Windsock, PointsWithTheWindAndHangsInCalm)
{
    const std::vector<glm::dvec3> feet{{100.0, 50.0, 7.0}};
    scenery::AirfieldNode node({}, feet);
    const auto tip = [&]
    {
        // The sock is the last thing of the last group; its far end lies along its own x.
        osg::Group* const group = node.node()->getChild(0)->asGroup();
        const osg::Matrixd matrix = group->getChild(1)->asTransform()->asMatrixTransform()->getMatrix();
        return osg::Vec3d(3.6, 0.0, 0.0) * matrix - osg::Vec3d(0.0, 0.0, 0.0) * matrix;
    };
    node.setWind({0.0, 8.0});
    EXPECT_NEAR(tip().y(), 3.6, 0.05) << "a southerly wind blows it to the north";
    EXPECT_NEAR(tip().z(), 0.0, 0.2);
    node.setWind({-3.0, 0.0});
    EXPECT_LT(tip().x(), -1.0);
    EXPECT_LT(tip().z(), -1.0) << "half lifted";
    node.setWind({0.0, 0.0});
    EXPECT_LT(tip().z(), -3.4);
}
