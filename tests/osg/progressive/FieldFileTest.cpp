// SPDX-License-Identifier: Apache-2.0
// Fields, and drawables without a node, in OpenSceneGraph's scene files.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osg/Program>
#include <osg/Texture2D>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include <osgPMObjects/ProgressiveField>
#include <osgPMObjects/ProgressiveNode>

#include "ProgressiveSubject.h"
#include "TestFolder.h"

namespace
{

using namespace osgPMObjects;

std::vector<FieldInstance> strewn(std::size_t count)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<FieldInstance> instances(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        FieldInstance& instance = instances[i];
        instance.position.set(1e6 + 300.0 * share(random), 300.0 * share(random), share(random) / 3.0);
        instance.attitude.makeRotate(6.0 * share(random), osg::Vec3d(share(random), share(random), 1.0));
        instance.scale = 0.1 + share(random);
        instance.kind = static_cast<std::uint32_t>(i % 3);
        instance.priority = {0.5 + share(random), i % 7 == 0};
    }
    return instances;
}

ProgressiveFieldSettings strewnSettings()
{
    ProgressiveFieldSettings settings;
    settings.budget = {{80.0, 20.5, 1.0 / 3.0}, 123456789012345, 1.75};
    settings.attention = {3.0, 0.25, 5.0, 20.0, {0.6, 0.0, -0.8}};
    settings.referencePixelsPerTangent = 1234.5;
    return settings;
}

/// Three kinds of two shapes with settings of their own.
osg::ref_ptr<ProgressiveField> strewnField()
{
    static const osg::ref_ptr<ProgressiveShape> torus =
        progressive::subjectOf(testsupport::torus(8, 6)).shape;
    static const osg::ref_ptr<ProgressiveShape> sheet =
        progressive::subjectOf(testsupport::waves(6, 5)).shape;
    std::vector<FieldKind> kinds{{torus}, {sheet}, {torus}};
    kinds[0].selection.method = core::SelectionMethod::budget;
    kinds[1].selection.tolerancePx = 1.0 / 3.0;
    kinds[1].switching = {.method = core::SwitchMethod::geomorph, .durationS = 0.7F, .staggerS = 0.0F};
    kinds[2].selection.alpha = {100.0, 250.0};
    osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    field->setName("strewn");
    EXPECT_TRUE(field->setContents(kinds, strewn(200)));
    EXPECT_TRUE(field->setSettings(strewnSettings()));
    return field;
}

void expectEqual(const std::vector<FieldInstance>& a, const std::vector<FieldInstance>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        EXPECT_EQ(a[i].position, b[i].position) << i;
        EXPECT_EQ(a[i].attitude, b[i].attitude) << i;
        EXPECT_EQ(a[i].scale, b[i].scale) << i;
        EXPECT_EQ(a[i].kind, b[i].kind) << i;
        EXPECT_EQ(a[i].priority.importance, b[i].priority.importance) << i;
        EXPECT_EQ(a[i].priority.isAttended, b[i].priority.isAttended) << i;
    }
}

class FieldFile : public testing::TestWithParam<const char*>
{
protected:
    std::string path() const { return (_folder / (std::string("field.") + GetParam())).string(); }
    std::string write(const osg::Node& node) const
    {
        EXPECT_TRUE(osgDB::writeNodeFile(node, path()));
        return path();
    }
    template<class Node>
    osg::ref_ptr<Node> readAgain(const osg::Node& node) const
    {
        const osg::ref_ptr<osg::Node> read = osgDB::readRefNodeFile(write(node));
        return dynamic_cast<Node*>(read.get());
    }

private:
    testsupport::TestFolder _folder{"field-file"};
};

TEST_P(FieldFile, GivesBackFieldsAsTheyWere)
{
    const osg::ref_ptr<ProgressiveField> written = strewnField(),
                                         field = readAgain<ProgressiveField>(*written);
    ASSERT_TRUE(field);
    EXPECT_EQ(field->getName(), "strewn");
    expectEqual(field->instances(), strewn(200));
    EXPECT_EQ(field->getBound(), written->getBound());

    ASSERT_EQ(field->kinds().size(), 3u);
    EXPECT_EQ(field->kinds()[0].selection.method, core::SelectionMethod::budget);
    EXPECT_EQ(field->kinds()[1].selection.tolerancePx, 1.0 / 3.0);
    EXPECT_EQ(field->kinds()[1].switching, written->kinds()[1].switching);
    EXPECT_EQ(field->kinds()[2].selection.alpha.goneM, 250.0);
    EXPECT_EQ(field->kinds()[0].shape, field->kinds()[2].shape);
    EXPECT_EQ(field->kinds()[0].shape->progressive().records,
              written->kinds()[0].shape->progressive().records);

    const ProgressiveFieldSettings wanted = strewnSettings();
    EXPECT_EQ(field->budget().cost, wanted.budget.cost);
    EXPECT_EQ(field->budget().budget, wanted.budget.budget);
    EXPECT_EQ(field->budget().band, wanted.budget.band);
    EXPECT_EQ(field->attention().attendedGain, wanted.attention.attendedGain);
    EXPECT_EQ(field->attention().peripheralGain, wanted.attention.peripheralGain);
    EXPECT_EQ(field->attention().gazeInnerDeg, wanted.attention.gazeInnerDeg);
    EXPECT_EQ(field->attention().gazeOuterDeg, wanted.attention.gazeOuterDeg);
    EXPECT_EQ(field->attention().gaze, wanted.attention.gaze);
    EXPECT_EQ(field->settings().referencePixelsPerTangent, wanted.referencePixelsPerTangent);
}

TEST_P(FieldFile, GivesBackWhatDrawsThem)
{
    const osg::ref_ptr<ProgressiveField> field = readAgain<ProgressiveField>(*strewnField());
    ASSERT_TRUE(field);
    const osg::StateSet& state = *field->getStateSet();
    const auto* const program =
        dynamic_cast<const osg::Program*>(state.getAttribute(osg::StateAttribute::PROGRAM));
    ASSERT_TRUE(program);
    EXPECT_EQ(program->getNumShaders(), 2u);
    EXPECT_FALSE(program->getAttribBindingList().empty());
    const auto* const texture =
        dynamic_cast<const osg::Texture2D*>(state.getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    ASSERT_TRUE(texture);
    ASSERT_TRUE(texture->getImage()) << "the white pixel is in the file, or made again";
    EXPECT_EQ(texture->getImage()->data()[0], 255);
}

TEST_P(FieldFile, LeavesAProgramOfTheSceneAlone)
{
    const osg::ref_ptr<ProgressiveField> written = strewnField();
    const osg::ref_ptr<osg::Program> own = new osg::Program;
    own->setName("the scene's");
    written->getOrCreateStateSet()->setAttributeAndModes(own);
    const osg::ref_ptr<ProgressiveField> field = readAgain<ProgressiveField>(*written);
    ASSERT_TRUE(field);
    EXPECT_EQ(field->getStateSet()->getAttribute(osg::StateAttribute::PROGRAM)->getName(), "the scene's");
}

TEST_P(FieldFile, SharesShapesWithNodes)
{
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    const osg::ref_ptr<ProgressiveField> field = strewnField();
    root->addChild(field);
    root->addChild(new ProgressiveNode(field->kinds()[0].shape));
    const osg::ref_ptr<osg::Group> read = readAgain<osg::Group>(*root);
    ASSERT_TRUE(read);
    const auto* const fieldRead = dynamic_cast<const ProgressiveField*>(read->getChild(0));
    const auto* const node = dynamic_cast<const ProgressiveNode*>(read->getChild(1));
    ASSERT_TRUE(fieldRead && node);
    EXPECT_EQ(fieldRead->kinds()[0].shape, node->shape());
}

TEST_P(FieldFile, KeepsAnEmptyField)
{
    const osg::ref_ptr<ProgressiveField> field =
        readAgain<ProgressiveField>(*osg::ref_ptr(new ProgressiveField));
    ASSERT_TRUE(field);
    EXPECT_TRUE(field->kinds().empty());
    EXPECT_EQ(field->instanceCount(), 0u);
}

TEST_P(FieldFile, StaysTheSameWhenWrittenAgain)
{
    const osg::ref_ptr<ProgressiveField> field = readAgain<ProgressiveField>(*strewnField());
    ASSERT_TRUE(field);
    const std::string first = testsupport::bytesOf(write(*field));
    EXPECT_EQ(testsupport::bytesOf(write(*readAgain<ProgressiveField>(*field))), first);
}

TEST_P(FieldFile, KeepsADrawableWithoutANode)
{
    const osg::ref_ptr<ProgressiveDrawable> written =
        new ProgressiveDrawable(progressive::torusAndSheet().shape);
    ASSERT_TRUE(written->setSteps(321));
    const osg::ref_ptr<ProgressiveDrawable> drawable = readAgain<ProgressiveDrawable>(*written);
    ASSERT_TRUE(drawable);
    EXPECT_EQ(drawable->steps(), 321u);
    EXPECT_EQ(progressive::trianglesOf(std::vector{drawable}),
              progressive::trianglesOf(std::vector{written}));
    EXPECT_EQ(drawable->getBoundingBox()._max, written->getBoundingBox()._max);
}

INSTANTIATE_TEST_SUITE_P(AllFormats, FieldFile, testing::Values("osgt", "osgb", "osgx"));

/// The text of a scene file, to be damaged.
struct DamagedFieldFile : testing::Test
{
    std::string textOf(const osg::Node& node) const
    {
        const std::string file = (folder / "field.osgt").string();
        EXPECT_TRUE(osgDB::writeNodeFile(node, file));
        return testsupport::bytesOf(file);
    }
    std::string messageOf(const std::string& text) const
    {
        const std::string file = folder.write("field.osgt", text).string();
        return osgDB::Registry::instance()->readNode(file, nullptr).message();
    }
    /// What reading says with one part of the text replaced.
    std::string complaintAbout(std::string text, const std::string& what, const std::string& instead) const
    {
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        if (at != std::string::npos) text.replace(at, what.size(), instead);
        return messageOf(text);
    }

    testsupport::TestFolder folder{"damaged-field"};
};

TEST_F(DamagedFieldFile, SaysWhatIsWrongWithAField)
{
    using testing::HasSubstr;
    const std::string text = textOf(*strewnField());
    const auto complaint = [&](const char* what, const char* instead)
    { return complaintAbout(text, what, instead); };
    EXPECT_THAT(complaint("instance=1", "instance=x"), HasSubstr("instance in a scene file"));
    EXPECT_THAT(complaint("instance=1", "instance=1,1"), HasSubstr("instance in a scene file"));
    EXPECT_THAT(complaint("instance=1", "tree=1"), HasSubstr("not known"));
    EXPECT_THAT(complaint("instance=1", "instance=inf,0,0,0,0,0,1,1,0,1,0"), HasSubstr("instance"));
    EXPECT_THAT(complaint("budget.band=1.75", "budget.band=0.5"), HasSubstr("ProgressiveField.budget.band"));
    EXPECT_THAT(complaint("attention.gaze=0.6", "attention.gaze=nan"),
                HasSubstr("ProgressiveField.attention.gaze"));
    EXPECT_THAT(complaint("method=budget", "method=guess"), HasSubstr("\"guess\""));
    EXPECT_THAT(complaint("switching.durationS=0.7", "switching.durationS=0"),
                HasSubstr("ProgressiveField.kinds[1].switching"));
    EXPECT_EQ(complaint("budget.band=1.75", "budget.band=1.5"), "") << "what is right is no complaint";
}

TEST_F(DamagedFieldFile, SaysWhatIsWrongWithAnInstance)
{
    const osg::ref_ptr<ProgressiveField> field = strewnField();
    ASSERT_TRUE(field->setContents(field->kinds(), std::vector<FieldInstance>(2)));
    const std::string text = textOf(*field), line = "instance=0,0,0,0,0,0,1,1,0,1,0";
    const auto complaint = [&](const char* instead) { return complaintAbout(text, line, instead); };
    using testing::HasSubstr;
    EXPECT_THAT(complaint("instance=0,0,0,0,0,0,1,-1,0,1,0"),
                HasSubstr("ProgressiveField.instances[0].scale"));
    EXPECT_THAT(complaint("instance=0,0,0,0,0,0,1,1,3,1,0"), HasSubstr("ProgressiveField.instances[0].kind"));
    EXPECT_THAT(complaint("instance=0,0,0,0,0,0,2,1,0,1,0"),
                HasSubstr("ProgressiveField.instances[0].attitude"));
    EXPECT_THAT(complaint("instance=0,0,0,0,0,0,1,1,0,0,0"), HasSubstr("instances[0].priority.importance"));
    EXPECT_THAT(complaint("instance=0,0,0,0,0,0,1,1,0,1,2"), HasSubstr("instance in a scene file"));
}

TEST_F(DamagedFieldFile, SaysWhatIsWrongWithADrawable)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable =
        new ProgressiveDrawable(progressive::torusAndSheet().shape);
    ASSERT_TRUE(drawable->setSteps(321));
    EXPECT_THAT(complaintAbout(textOf(*drawable), "Steps 321", "Steps 99999999"),
                testing::HasSubstr("ProgressiveDrawable.steps"));
}

TEST_F(DamagedFieldFile, NeverEndsTheProgram)
{
    const std::string text = textOf(*strewnField());
    const std::size_t from = text.find("Contents");
    std::mt19937 random(11);
    for (int round = 0; round < 60; ++round)
    {
        std::string changed = text;
        changed[from + 8 + random() % (text.size() - from - 8)] = static_cast<char>(' ' + random() % 90);
        (void)messageOf(changed);
    }
    for (int tenths = 1; tenths < 10; ++tenths)
        (void)messageOf(text.substr(0, from + (text.size() - from) * static_cast<std::size_t>(tenths) / 10));
}

} // namespace
