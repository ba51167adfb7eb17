// SPDX-License-Identifier: Apache-2.0
// A program that is not linked with the library (as osgviewer) reads and writes its objects: OSG loads the
// serializers by itself.
#include <gtest/gtest.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include "TestFolder.h"

namespace
{

constexpr const char* kScene = OSGTRAINER_SOURCE_DIR "/tests/osg/progressive/waves.osgt";

TEST(SerializersLibrary, IsLoadedForASceneOfProgressiveObjects)
{
    // The mutation first: without the folder nothing knows the class.
    EXPECT_FALSE(osgDB::readRefNodeFile(kScene));
    osgDB::Registry::instance()->getLibraryFilePathList().push_front(OSGTRAINER_PLUGIN_FOLDER);
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(kScene);
    ASSERT_TRUE(node);
    EXPECT_STREQ(node->className(), "ProgressiveNode");
    EXPECT_GT(node->getBound().radius(), 0.5F);

    const testsupport::TestFolder folder("serializers-library");
    const std::string file = (folder / "again.osgb").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*node, file));
    const osg::ref_ptr<osg::Node> again = osgDB::readRefNodeFile(file);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->getBound(), node->getBound());
}

} // namespace
