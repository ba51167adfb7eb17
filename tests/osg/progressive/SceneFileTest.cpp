// SPDX-License-Identifier: Apache-2.0
// Progressive objects in OpenSceneGraph's scene files.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include <osgPMObjects/ProgressiveNode>

#include "ProgressiveSubject.h"
#include "TestFolder.h"

namespace
{

using namespace osgPMObjects;

core::SelectionSettings settingsNotDefault()
{
    core::SelectionSettings settings;
    settings.method = core::SelectionMethod::overlappingRanges;
    settings.ranges = {{10.0, 1.0 / 3.0e7 + 20.0}, {0, 5, 9}};
    settings.overlappingRanges = {{{9.0, 11.0}, {19.0, 21.5}}, {0, 7, 11}};
    settings.areaRows = {{5000.0, 70.0}, {0, 3, 8}};
    settings.referenceM = 0.1;
    settings.trianglePx = 2.25;
    settings.tolerancePx = 3.0000000001;
    settings.errorKind = core::ErrorKind::rootMeanSquare;
    settings.leastFaces = 24;
    settings.weights = {0.25f, 0.1f, 3.0f};
    settings.band = 1.3;
    settings.continuousBand = 1.05;
    settings.alpha = {500.0, std::numeric_limits<double>::infinity()};
    return settings;
}

void expectEqual(const core::SelectionSettings& a, const core::SelectionSettings& b)
{
    EXPECT_EQ(a.method, b.method);
    EXPECT_EQ(a.ranges.boundariesM, b.ranges.boundariesM);
    EXPECT_EQ(a.ranges.steps, b.ranges.steps);
    EXPECT_EQ(a.overlappingRanges.steps, b.overlappingRanges.steps);
    ASSERT_EQ(a.overlappingRanges.boundaries.size(), b.overlappingRanges.boundaries.size());
    for (std::size_t i = 0; i < a.overlappingRanges.boundaries.size(); ++i)
    {
        EXPECT_EQ(a.overlappingRanges.boundaries[i].nearM, b.overlappingRanges.boundaries[i].nearM);
        EXPECT_EQ(a.overlappingRanges.boundaries[i].farM, b.overlappingRanges.boundaries[i].farM);
    }
    EXPECT_EQ(a.areaRows.leastPx, b.areaRows.leastPx);
    EXPECT_EQ(a.areaRows.steps, b.areaRows.steps);
    EXPECT_EQ(a.referenceM, b.referenceM);
    EXPECT_EQ(a.trianglePx, b.trianglePx);
    EXPECT_EQ(a.tolerancePx, b.tolerancePx);
    EXPECT_EQ(a.errorKind, b.errorKind);
    EXPECT_EQ(a.leastFaces, b.leastFaces);
    EXPECT_EQ(a.weights.normal, b.weights.normal);
    EXPECT_EQ(a.weights.texCoord, b.weights.texCoord);
    EXPECT_EQ(a.weights.colour, b.weights.colour);
    EXPECT_EQ(a.band, b.band);
    EXPECT_EQ(a.continuousBand, b.continuousBand);
    EXPECT_EQ(a.alpha.fadeM, b.alpha.fadeM);
    EXPECT_EQ(a.alpha.goneM, b.alpha.goneM);
}

/// Two nodes of one shape, and between them a node of another shape. The first has its own settings and a
/// second child.
osg::ref_ptr<osg::Group> scene()
{
    const osg::ref_ptr<ProgressiveShape> shape = progressive::torusAndSheet().shape;
    shape->states()[0]->setName("the torus's");
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    const osg::ref_ptr<ProgressiveNode> first = new ProgressiveNode(shape),
                                        second = new ProgressiveNode(shape);
    first->setName("the first");
    ProgressiveNodeSettings settings;
    settings.selection = settingsNotDefault();
    settings.switching = {.method = core::SwitchMethod::geomorph, .durationS = 0.7F};
    settings.priority = {2.5, true};
    settings.number = 17;
    settings.referencePixelsPerTangent = 1111.25;
    EXPECT_TRUE(first->setSettings(settings));
    const osg::ref_ptr<osg::Group> other = new osg::Group;
    other->setName("beside it");
    first->addChild(other);
    root->addChild(first);
    root->addChild(new ProgressiveNode(progressive::subjectOf(testsupport::torus(8, 6)).shape));
    root->addChild(second);
    root->addChild(new ProgressiveNode);
    return root;
}

ProgressiveNode* nodeOf(osg::Group& root, unsigned int i)
{
    return dynamic_cast<ProgressiveNode*>(root.getChild(i));
}

class SceneFile : public testing::TestWithParam<const char*>
{
protected:
    std::string write(const osg::Node& node) const
    {
        const std::string file = (_folder / (std::string("scene.") + GetParam())).string();
        EXPECT_TRUE(osgDB::writeNodeFile(node, file));
        return file;
    }
    static osg::ref_ptr<osg::Group> read(const std::string& file)
    {
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(file);
        return node ? node->asGroup() : nullptr;
    }

    testsupport::TestFolder _folder{"scene-file"};
};

TEST_P(SceneFile, GivesBackNodesAsTheyWere)
{
    const osg::ref_ptr<osg::Group> written = scene(), root = read(write(*written));
    ASSERT_TRUE(root);
    ASSERT_EQ(root->getNumChildren(), 4u);
    ProgressiveNode* const node = nodeOf(*root, 0);
    ASSERT_TRUE(node);
    EXPECT_EQ(node->getName(), "the first");
    expectEqual(node->selection(), settingsNotDefault());
    EXPECT_EQ(node->switching().method, core::SwitchMethod::geomorph);
    EXPECT_EQ(node->switching().durationS, 0.7F);
    EXPECT_EQ(node->settings().number, 17u);
    EXPECT_EQ(node->priority().importance, 2.5);
    EXPECT_TRUE(node->priority().isAttended);
    EXPECT_EQ(node->settings().referencePixelsPerTangent, 1111.25);
    ASSERT_EQ(node->getNumChildren(), 2u);
    EXPECT_EQ(node->getChild(0), node->drawable());
    EXPECT_EQ(node->getChild(1)->getName(), "beside it");

    const ProgressiveShape &was = *nodeOf(*written, 0)->shape(), &is = *node->shape();
    EXPECT_EQ(is.progressive().records, was.progressive().records);
    EXPECT_EQ(is.progressive().mesh.positions, was.progressive().mesh.positions);
    ASSERT_EQ(is.states().size(), 2u);
    EXPECT_EQ(is.states()[0]->getName(), "the torus's");
    EXPECT_EQ(is.groups().size(), 2u);

    EXPECT_EQ(nodeOf(*root, 1)->getNumChildren(), 1u);
    ASSERT_TRUE(nodeOf(*root, 3));
    EXPECT_FALSE(nodeOf(*root, 3)->shape());
}

TEST_P(SceneFile, HasASharedShapeOnce)
{
    const std::string file = write(*scene());
    const osg::ref_ptr<osg::Group> root = read(file);
    ASSERT_TRUE(root);
    EXPECT_EQ(nodeOf(*root, 0)->shape(), nodeOf(*root, 2)->shape());
    EXPECT_NE(nodeOf(*root, 0)->shape(), nodeOf(*root, 1)->shape());
    EXPECT_NE(nodeOf(*root, 0)->drawable(), nodeOf(*root, 2)->drawable());

    // The mutation: with a shape of its own the second node makes the file larger by that shape.
    const osg::ref_ptr<osg::Group> twice = scene();
    twice->setChild(2, new ProgressiveNode(progressive::torusAndSheet().shape));
    const auto size = std::filesystem::file_size(file);
    EXPECT_GT(std::filesystem::file_size(write(*twice)), size + size / 2);
}

TEST_P(SceneFile, StaysTheSameWhenWrittenAgain)
{
    using testsupport::bytesOf;
    const osg::ref_ptr<osg::Group> root = read(write(*scene()));
    const std::string first = bytesOf(write(*root));
    const osg::ref_ptr<osg::Group> again = read((_folder / (std::string("scene.") + GetParam())).string());
    EXPECT_EQ(bytesOf(write(*again)), first);
}

TEST_P(SceneFile, CutOffAnywhereIsAnErrorOrAPart)
{
    const std::string file = write(*scene());
    const auto size = std::filesystem::file_size(file);
    const auto shapeEnds = size * 3 / 5;
    for (std::size_t part = 1; part < 12; ++part)
    {
        std::filesystem::resize_file(file, shapeEnds * (12 - part) / 12);
        auto result = osgDB::Registry::instance()->readNode(file, nullptr);
        const osg::Group* const root = result.getNode() ? result.getNode()->asGroup() : nullptr;
        EXPECT_FALSE(root && root->getNumChildren() == 4) << part;
    }
}

INSTANTIATE_TEST_SUITE_P(AllFormats, SceneFile, testing::Values("osgt", "osgb", "osgx"));

/// The text of the scene file, to be damaged.
struct DamagedSceneFile : testing::Test
{
    DamagedSceneFile()
    {
        const std::string file = (folder / "scene.osgt").string();
        EXPECT_TRUE(osgDB::writeNodeFile(*scene(), file));
        text = testsupport::bytesOf(file);
    }

    osgDB::ReaderWriter::ReadResult read(const std::string& changed) const
    {
        return osgDB::Registry::instance()->readNode(folder.write("scene.osgt", changed).string(), nullptr);
    }
    /// Returns what reading says with one part of the text replaced.
    std::string complaintAbout(const std::string& what, const std::string& instead) const
    {
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        std::string changed = text;
        if (at != std::string::npos) changed.replace(at, what.size(), instead);
        return read(changed).message();
    }

    testsupport::TestFolder folder{"damaged-scene"};
    std::string text;
};

TEST_F(DamagedSceneFile, SaysWhatIsWrong)
{
    using testing::HasSubstr;
    EXPECT_THAT(complaintAbout("method=overlapping-ranges", "method=guess"), HasSubstr("\"guess\""));
    EXPECT_THAT(complaintAbout("tolerancePx=3", "tolerancePx=-3"), HasSubstr("tolerance"));
    EXPECT_THAT(complaintAbout("tolerancePx", "tollerancePx"), HasSubstr("not known"));
    EXPECT_THAT(complaintAbout("overlappingRanges.steps=0,7,11", "overlappingRanges.steps=0,7,99999999"),
                HasSubstr("none of the model's"));
    EXPECT_THAT(complaintAbout("isAttended=1", "isAttended=perhaps"), HasSubstr("isAttended"));
    EXPECT_THAT(complaintAbout("importance=2.5", "importance=0"), HasSubstr("importance"));
    EXPECT_EQ(complaintAbout("importance=2.5", "importance=3"), ""); // a good value is not refused
}

TEST_F(DamagedSceneFile, IsFoundByTheCheckSums)
{
    const std::size_t from = text.find("Levels "),
                      digits = text.find_first_of("abcdef", text.find('{', from));
    ASSERT_NE(digits, std::string::npos);
    for (const std::size_t at : {digits + 401, digits + 1001, digits + 4002, digits + 8001})
    {
        std::string changed = text;
        changed[at] = changed[at] == '7' ? '8' : '7';
        EXPECT_THAT(read(changed).message(), testing::HasSubstr("progressive shape")) << at - digits;
        changed[at] = 'x';
        EXPECT_FALSE(read(changed).validNode());
    }
}

TEST_F(DamagedSceneFile, NeverEndsTheProgram)
{
    const std::size_t from = text.find("ProgressiveNode");
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round)
    {
        std::string changed = text;
        // Outside OSG's header, inside our objects: in digits and sizes alike.
        changed[from + 15 + random() % (text.size() - from - 15)] = static_cast<char>(' ' + random() % 90);
        (void)read(changed);
    }
}

} // namespace
