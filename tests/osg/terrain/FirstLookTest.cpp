// SPDX-License-Identifier: Apache-2.0
// What a viewer shows of a terrain before anyone has set background or camera: the same by API and by plugin.
#include <gtest/gtest.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgGA/TerrainManipulator>
#include <osgViewer/Viewer>

#include <osgTerrainROAM/FirstLook>
#include <osgTerrainROAM/RoamTerrain>

#include "RasterWriter.h"

namespace
{

const osg::Vec4 kBlue(0.2f, 0.2f, 0.4f, 1.0f); ///< the background of osgViewer

std::filesystem::path writeGrid(const TemporaryFolder& folder)
{
    RasterSpec spec;
    spec.columns = 40;
    spec.rows = 30;
    spec.geoTransform = northUp3Seconds(30);
    spec.epsg = 4326;
    writeRaster(folder / "dem.tif", "GTiff", spec);
    return folder / "dem.tif";
}

/// Sends the first frame event to the event callbacks of a node; no window is needed.
void sendFrame(osg::Node& node, osgViewer::Viewer& viewer)
{
    const osg::ref_ptr<osgGA::GUIEventAdapter> event = new osgGA::GUIEventAdapter;
    event->setEventType(osgGA::GUIEventAdapter::FRAME);
    for (osg::Callback* callback = node.getEventCallback(); callback;
         callback = callback->getNestedCallback())
        if (auto* const handler = dynamic_cast<osgGA::GUIEventHandler*>(callback))
            handler->handle(*event, viewer, &node, nullptr);
}

struct Look
{
    osg::Vec4 background;
    osg::Vec3d eye;
};

Look firstLookAt(osg::Node* node, const osg::Vec4& background = kBlue)
{
    osgViewer::Viewer viewer;
    viewer.getCamera()->setClearColor(background);
    viewer.setCameraManipulator(new osgGA::TerrainManipulator);
    viewer.setSceneData(node);
    sendFrame(*node, viewer);
    osg::Vec3d eye, centre, up;
    viewer.getCameraManipulator()->getHomePosition(eye, centre, up);
    return {viewer.getCamera()->getClearColor(), eye};
}

} // namespace

TEST(FirstLook, IsTheSameByApiAndByPlugin)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = writeGrid(folder);
    osgDB::Registry::instance()->setLibraryFilePathList(OSGTRAINER_PLUGIN_FOLDER);
    const auto opened = osgTerrainROAM::openTerrain(file);
    ASSERT_TRUE(opened) << opened.error().message();
    const osg::ref_ptr<osg::Node> read = osgDB::readRefNodeFile(file.string() + ".roam");
    ASSERT_TRUE(read);
    const Look byApi = firstLookAt(*opened), byPlugin = firstLookAt(read);
    const osgSky::AtmosphereLight& light = (*opened)->atmosphere()->light();
    const osg::Vec3f horizon = osgSky::displayColour(light.horizon, light.exposure);
    EXPECT_EQ(byApi.background, osg::Vec4(horizon, 1.0f));
    EXPECT_EQ(byApi.background, byPlugin.background);
    EXPECT_EQ(byApi.eye, byPlugin.eye);
}

TEST(FirstLook, LeavesTheBackgroundOfTheProgramAsItIs)
{
    const TemporaryFolder folder;
    const auto opened = osgTerrainROAM::openTerrain(writeGrid(folder));
    ASSERT_TRUE(opened);
    const osg::Vec4 red(1.0f, 0.0f, 0.0f, 1.0f);
    EXPECT_EQ(firstLookAt(*opened, red).background, red);
}

TEST(FirstLook, ATerrainWithoutItKeepsTheBlueBackground)
{
    const TemporaryFolder folder;
    const auto opened = osgTerrainROAM::openTerrain(writeGrid(folder));
    ASSERT_TRUE(opened);
    (*opened)->setEventCallback(nullptr);
    EXPECT_EQ(firstLookAt(*opened).background, kBlue);
}
