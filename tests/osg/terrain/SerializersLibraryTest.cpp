// SPDX-License-Identifier: Apache-2.0
// A program that does not link osgTerrainROAM (as osgviewer) reads a scene with a terrain: OSG finds the
// library by itself.
#include <gtest/gtest.h>

#include <osg/Node>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include "RasterWriter.h"

namespace
{

TEST(TerrainSerializersLibrary, IsLoadedForASceneWithATerrain)
{
    TemporaryFolder folder;
    RasterSpec spec;
    spec.columns = 40;
    spec.rows = 30;
    spec.geoTransform = northUp3Seconds(30);
    spec.epsg = 4326;
    writeRaster(folder / "dem.tif", "GTiff", spec);
    const std::string scene = (folder / "scene.osgt").string();
    writeBytes(scene, "#Ascii Scene\n#Version 162\n#Generator OpenSceneGraph "
                      "3.6.5\n\nosgTerrainROAM::RoamTerrain {\n  UniqueID 1\n"
                      "  Source \"" +
                          (folder / "dem.tif").string() +
                          "\"\n  Settings 1 {\n    errorTolerancePx=2\n  }\n}\n");
    // The mutation first: without the folder of the library nobody knows the class.
    EXPECT_FALSE(osgDB::readRefNodeFile(scene));
    osgDB::Registry::instance()->getLibraryFilePathList().push_front(OSGTRAINER_PLUGIN_FOLDER);
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(scene);
    ASSERT_TRUE(node);
    EXPECT_STREQ(node->className(), "RoamTerrain");
    EXPECT_GT(node->getBound().radius(), 1000.0f);
}

} // namespace
