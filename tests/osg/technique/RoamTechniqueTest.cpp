// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include <osgDB/Registry>

#include <osgTerrainROAM/RoamTechnique>

#include "HandCull.h"
#include "TechniqueScene.h"

namespace
{

using namespace techniquescene;
using handcull::cameraAt;
using handcull::cull;
using osgTerrain::TerrainTile;
using osgTerrainROAM::RoamTechnique;

const osg::Vec3d kEye(900, -300, 700);
const osg::Vec3d kNorth(900, 2000, 200);

/// A terrain of one tile with the technique as its prototype.
struct OneTile
{
    explicit OneTile(const TileSpec& spec = {}) : terrain(terrainOf(1, spec))
    {
        terrain->setTerrainTechniquePrototype(new RoamTechnique);
    }

    TerrainTile& tile() { return static_cast<TerrainTile&>(*terrain->getChild(0)); }
    RoamTechnique& technique() { return dynamic_cast<RoamTechnique&>(*tile().getTerrainTechnique()); }
    const osgTerrainROAM::core::RoamTile* ground() { return technique().drawable()->tile().get(); }

    std::uint64_t triangles(unsigned int frame)
    {
        return cull(*terrain, *cameraAt(kEye, kNorth), frame).triangles();
    }

    void update()
    {
        osgUtil::UpdateVisitor visitor;
        visitor.setFrameStamp(new osg::FrameStamp);
        terrain->accept(visitor);
    }

    osg::ref_ptr<osgTerrain::Terrain> terrain;
};

} // namespace

TEST(RoamTechnique, IsClonedFromTheTerrainsPrototypeAndCulls)
{
    OneTile scene;
    const std::uint64_t towards = scene.triangles(1);
    EXPECT_GT(towards, 100u);
    EXPECT_LT(towards, 2u * 64 * 64);
    const auto away = cameraAt(kEye, osg::Vec3d(900, -5000, 700));
    EXPECT_TRUE(cull(*scene.terrain, *away, 2).drawables.empty());
}

TEST(RoamTechnique, HandsItsSettingsOn)
{
    OneTile scene;
    auto* const prototype = static_cast<RoamTechnique*>(scene.terrain->getTerrainTechniquePrototype());
    ASSERT_TRUE(prototype->setErrorTolerancePx(8.0));
    prototype->setMorphing(true);
    const std::uint64_t coarse = scene.triangles(1);
    EXPECT_TRUE(scene.technique().drawable()->settings().morphing);
    scene.technique().setMorphing(false);
    ASSERT_TRUE(scene.technique().setErrorTolerancePx(0.5));
    EXPECT_GT(scene.triangles(2), 2 * coarse);
    ASSERT_TRUE(scene.technique().setMaxTriangles(300));
    EXPECT_LE(scene.triangles(3), 310u);
}

TEST(RoamTechnique, RefusesSettingsThatAreOutOfRangeAndChangesNothing)
{
    const osg::ref_ptr<RoamTechnique> technique = new RoamTechnique;
    for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    {
        const auto set = technique->setErrorTolerancePx(wrong);
        ASSERT_FALSE(set) << wrong;
        EXPECT_EQ(set.error().place, "RoamTechnique.errorTolerancePx");
    }
    EXPECT_EQ(technique->setMaxTriangles(1).error().place, "RoamTechnique.maxTriangles");
    EXPECT_EQ(technique->settings(), osgTerrainROAM::RoamTechniqueSettings());
}

TEST(RoamTechnique, ASceneFileStoresItsSettings)
{
    const osg::ref_ptr<RoamTechnique> technique = new RoamTechnique;
    ASSERT_TRUE(technique->setSettings({.errorTolerancePx = 0.1, .maxTriangles = 12345, .morphing = true}));
    for (const char* format : {"osgt", "osgb"})
    {
        osgDB::ReaderWriter* const files = osgDB::Registry::instance()->getReaderWriterForExtension(format);
        ASSERT_TRUE(files);
        std::stringstream file;
        const osg::ref_ptr<osgDB::Options> options =
            new osgDB::Options(std::string(format) == "osgt" ? "Ascii" : "");
        ASSERT_TRUE(files->writeObject(*technique, file, options).success()) << format;
        const osg::ref_ptr<osg::Object> again = files->readObject(file, options).getObject();
        const auto* const read = dynamic_cast<const RoamTechnique*>(again.get());
        ASSERT_TRUE(read) << format;
        EXPECT_EQ(read->settings(), technique->settings()) << format;
    }
}

TEST(RoamTechnique, TakesANewElevationLayerWhenTheTileIsDirty)
{
    OneTile scene;
    scene.triangles(1);
    const float before = scene.ground()->tile.samples().heightM(30, 30);
    osg::ref_ptr<osgTerrain::HeightFieldLayer> raised = elevationOf({});
    raised->setLocator(scene.tile().getLocator());
    for (float& height : raised->getHeightField()->getHeightList())
        height += 100.0f;
    scene.tile().setElevationLayer(raised);
    scene.update();
    EXPECT_EQ(scene.ground()->tile.samples().heightM(30, 30), before) << "not dirty yet";
    scene.tile().setDirty(true);
    scene.update();
    EXPECT_EQ(scene.ground()->tile.samples().heightM(30, 30), before + 100.0f);
    EXPECT_FALSE(scene.tile().getDirty());
    EXPECT_GT(scene.triangles(2), 100u);
}

TEST(RoamTechnique, LeavesTheGroundWhereOnlyTheImageryIsDirty)
{
    OneTile scene;
    scene.triangles(1);
    const auto* const ground = scene.ground();
    const auto* const drawable = scene.technique().drawable();
    scene.tile().setDirtyMask(TerrainTile::IMAGERY_DIRTY);
    scene.update();
    EXPECT_EQ(scene.ground(), ground);
    EXPECT_NE(scene.technique().drawable(), drawable);
    scene.tile().setDirtyMask(TerrainTile::ELEVATION_DIRTY);
    scene.update();
    EXPECT_NE(scene.ground(), ground);
}

TEST(RoamTechnique, FollowsTheTerrainsVerticalScale)
{
    OneTile scene;
    scene.triangles(1);
    const float before = scene.ground()->tile.samples().heightM(10, 10);
    scene.terrain->setVerticalScale(2.0f);
    scene.update();
    EXPECT_FLOAT_EQ(scene.ground()->tile.samples().heightM(10, 10), 2.0f * before);
}

TEST(RoamTechnique, AnotherThreadsWorkIsTakenByTheNextUpdate)
{
    OneTile scene;
    scene.triangles(1);
    const auto* const ground = scene.ground();
    scene.tile().init(TerrainTile::ALL_DIRTY, true);
    EXPECT_EQ(scene.ground(), ground) << "what a frame may be drawing stays";
    scene.update();
    EXPECT_NE(scene.ground(), ground);
}

TEST(RoamTechnique, DrawsNothingWithoutALocatorAndSaysNoMoreThanThat)
{
    const osg::ref_ptr<TerrainTile> tile = new TerrainTile;
    tile->setTerrainTechnique(new RoamTechnique);
    EXPECT_TRUE(cull(*tile, *cameraAt(kEye, kNorth), 1).drawables.empty());
}

TEST(RoamTechnique, ATileInDegreesIsRefinedAsOneInMetres)
{
    OneTile metres, degrees;
    const double scale = 1.0 / 111000.0;
    degrees.tile().getLocator()->setTransform(osg::Matrixd::scale(1920.0 * scale, 1920.0 * scale, scale));
    const std::uint64_t expected = metres.triangles(1);
    const auto camera = cameraAt(kEye * scale, kNorth * scale);
    camera->setProjectionMatrixAsPerspective(46.8, 800.0 / 600.0, scale, 1e6 * scale);
    const auto found = cull(*degrees.terrain, *camera, 1, true);
    EXPECT_NEAR(static_cast<double>(found.triangles()), static_cast<double>(expected), 0.02 * expected);
    double left, right, bottom, top, nearPlane, farPlane;
    ASSERT_TRUE(found.projection.getFrustum(left, right, bottom, top, nearPlane, farPlane));
    EXPECT_LT(nearPlane, 700 * scale);
    EXPECT_GT(nearPlane, 1e-6);
    EXPECT_LT(farPlane, 6000 * scale);
}
