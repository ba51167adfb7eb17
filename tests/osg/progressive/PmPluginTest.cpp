// SPDX-License-Identifier: Apache-2.0
// Progressive meshes as files of OpenSceneGraph.
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osg/Geode>
#include <osg/Material>
#include <osg/ShapeDrawable>
#include <osg/Texture2D>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/PmNode>

#include "Random.h"
#include "TestFolder.h"

namespace
{

using namespace osgPMObjects;

class PmPlugin : public testing::Test
{
protected:
    void SetUp() override
    {
        osgDB::Registry::instance()->getLibraryFilePathList().push_front(OSGTRAINER_PLUGIN_FOLDER);
    }
    void TearDown() override { osgDB::Registry::instance()->getLibraryFilePathList().pop_front(); }

    /// A textured red ball, and a line beside it.
    static osg::ref_ptr<osg::Group> model()
    {
        const osg::ref_ptr<osg::Group> group = new osg::Group;
        const osg::ref_ptr<osg::Geode> ball = new osg::Geode;
        ball->addDrawable(new osg::ShapeDrawable(new osg::Sphere({}, 2.0F)));
        const osg::ref_ptr<osg::Material> red = new osg::Material;
        red->setDiffuse(osg::Material::FRONT_AND_BACK, {1.0F, 0.0F, 0.0F, 1.0F});
        ball->getOrCreateStateSet()->setAttributeAndModes(red);
        const osg::ref_ptr<osg::Image> picture = new osg::Image;
        picture->allocateImage(4, 4, 1, GL_RGB, GL_UNSIGNED_BYTE);
        std::fill_n(picture->data(), picture->getTotalSizeInBytes(), static_cast<unsigned char>(77));
        ball->getStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D(picture));
        group->addChild(ball);
        const osg::ref_ptr<osg::Geometry> line = new osg::Geometry;
        const osg::ref_ptr<osg::Vec3Array> ends = new osg::Vec3Array(2);
        (*ends)[1].set(0.0F, 0.0F, 5.0F);
        line->setVertexArray(ends);
        line->addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, 2));
        group->addChild(line);
        return group;
    }

    static osg::ref_ptr<ProgressiveNode> readBack(const std::string& file)
    {
        return dynamic_cast<ProgressiveNode*>(osgDB::readRefNodeFile(file).get());
    }

    testsupport::TestFolder _folder{"pm-plugin"};
};

/// The content of a file, counted; it has to be the same, however the file is read.
struct Counts
{
    std::size_t positions = 0, wedges = 0, records = 0, groups = 0;
    std::uint32_t steps = 0;
    unsigned children = 0;
    bool operator==(const Counts&) const = default;
};

std::optional<Counts> countsOf(const osg::ref_ptr<osg::Object>& object)
{
    const auto* const node = dynamic_cast<const ProgressiveNode*>(object.get());
    if (!node || !node->shape()) return std::nullopt;
    const core::ProgressiveMesh& progressive = node->shape()->progressive();
    return Counts{
        progressive.mesh.positions.size(), progressive.mesh.wedgeCount(), progressive.records.size(),
        node->shape()->groups().size(),    progressive.stepCount,         node->getNumChildren()};
}

/// All ways of osgDB to read a file, except that of readBack().
std::vector<std::optional<Counts>> countsByOtherWays(const std::string& file)
{
    std::vector<std::optional<Counts>> counts{countsOf(osgDB::readRefObjectFile(file)),
                                              countsOf(osgDB::readRefFile<osg::Object>(file))};
    osgDB::ReaderWriter* const plugin = osgDB::Registry::instance()->getReaderWriterForExtension("pm");
    counts.push_back(countsOf(plugin->readObject(file, nullptr).getObject()));
    std::ifstream ofObject(file, std::ios::binary), ofNode(file, std::ios::binary);
    counts.push_back(countsOf(plugin->readObject(ofObject, nullptr).getObject()));
    counts.push_back(countsOf(plugin->readNode(ofNode, nullptr).getObject()));
    return counts;
}

TEST_F(PmPlugin, WritesAnyModelAndReadsAProgressiveObject)
{
    const std::string file = (_folder / "ball.pm").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), file));
    const osg::ref_ptr<ProgressiveNode> node = readBack(file);
    ASSERT_TRUE(node);
    const auto made = makeProgressive(*model(), "model", {.ladder = std::nullopt});
    ASSERT_TRUE(made);
    EXPECT_EQ(node->shape()->progressive().records, made->node->shape()->progressive().records);
    EXPECT_EQ(node->shape()->progressive().mesh.positions, made->node->shape()->progressive().mesh.positions);
    EXPECT_EQ(node->getNumChildren(), 2u); // the line, too

    ASSERT_EQ(node->shape()->groups().size(), 1u);
    const osg::StateSet* const state = node->shape()->groups()[0].state;
    ASSERT_TRUE(state);
    const auto* const red =
        dynamic_cast<const osg::Material*>(state->getAttribute(osg::StateAttribute::MATERIAL));
    ASSERT_TRUE(red);
    EXPECT_EQ(red->getDiffuse(osg::Material::FRONT), osg::Vec4(1.0F, 0.0F, 0.0F, 1.0F));
    const auto* const texture =
        dynamic_cast<const osg::Texture2D*>(state->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    ASSERT_TRUE(texture);
    ASSERT_TRUE(texture->getImage());
    EXPECT_EQ(texture->getImage()->data()[0], 77);

    const std::string again = (_folder / "again.pm").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*node, again));
    ASSERT_TRUE(readBack(again));
    EXPECT_EQ(readBack(again)->shape()->progressive().records, node->shape()->progressive().records);
}

TEST_F(PmPlugin, QuantisesWhereAsked)
{
    const std::string file = (_folder / "ball.pm").string(), smaller = (_folder / "small.pm").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), file));
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("quantised");
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), smaller, options));
    EXPECT_LT(std::filesystem::file_size(smaller), std::filesystem::file_size(file));
    EXPECT_TRUE(readBack(smaller));
}

TEST_F(PmPlugin, MeasuresLevelsWhereAsked)
{
    const std::string file = (_folder / "ball.pm").string(), measured = (_folder / "measured.pm").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), file));
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("measured");
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), measured, options));
    ASSERT_TRUE(readBack(file) && readBack(measured));
    EXPECT_TRUE(readBack(file)->shape()->progressive().ladder.empty());
    EXPECT_GT(readBack(measured)->shape()->progressive().ladder.size(), 10u);
}

TEST_F(PmPlugin, ReadsTheSameAsAnObjectAsANodeAndFromAStream)
{
    const std::string file = (_folder / "ball.pm").string(), other = (_folder / "cone.pm").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), file));
    const auto expected = countsOf(readBack(file));
    ASSERT_TRUE(expected);
    EXPECT_GT(expected->records, 100u);
    EXPECT_EQ(expected->children, 2u);
    for (const auto& counts : countsByOtherWays(file))
        EXPECT_EQ(counts, expected);

    const osg::ref_ptr<osg::Geode> cone = new osg::Geode;
    cone->addDrawable(new osg::ShapeDrawable(new osg::Cone({}, 1.0F, 2.0F)));
    ASSERT_TRUE(osgDB::writeObjectFile(*cone, other));
    EXPECT_EQ(countsOf(osgDB::readRefObjectFile(other)), countsOf(readBack(other)));
    EXPECT_NE(countsOf(osgDB::readRefObjectFile(other)), expected) << "another file would be noticed";
}

TEST_F(PmPlugin, GivesNoObjectOfWhatIsNoFileOfItsOwn)
{
    const std::string file = (_folder / "ball.pm").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), file));
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(300).put('?');
    osgDB::ReaderWriter* const plugin = osgDB::Registry::instance()->getReaderWriterForExtension("pm");
    using Result = osgDB::ReaderWriter::ReadResult;
    Result damaged = plugin->readObject(file, nullptr);
    EXPECT_FALSE(damaged.validObject());
    EXPECT_THAT(damaged.message(), testing::HasSubstr("check sum"));
    EXPECT_EQ(plugin->readObject((_folder / "none.pm").string(), nullptr).status(), Result::FILE_NOT_FOUND);
    EXPECT_EQ(plugin->readObject("ball.obj", nullptr).status(), Result::FILE_NOT_HANDLED);
    EXPECT_FALSE(osgDB::readRefObjectFile(file));
}

TEST_F(PmPlugin, SaysWhatIsWrongWithAFile)
{
    const std::string file = (_folder / "ball.pm").string();
    ASSERT_TRUE(osgDB::writeNodeFile(*model(), file));
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(300).put('?');
    auto read = osgDB::Registry::instance()->readNode(file, nullptr);
    EXPECT_FALSE(read.validNode());
    EXPECT_THAT(read.message(), testing::HasSubstr("check sum"));
}

/// An image of noise, which hardly compresses.
osg::ref_ptr<osg::Image> noise(int side, GLenum format)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(side, side, 1, format, GL_UNSIGNED_BYTE, 1);
    testsupport::Random random(3);
    for (unsigned i = 0; i < image->getTotalSizeInBytes(); ++i)
        image->data()[i] = static_cast<unsigned char>(random.below(256));
    return image;
}

osg::ref_ptr<osg::Image> imageOf(const ProgressiveNode& node)
{
    auto* const texture = dynamic_cast<osg::Texture2D*>(
        node.shape()->states()[0]->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    return texture ? texture->getImage() : nullptr;
}

void setImage(osg::Group& model, osg::Image* image)
{
    model.getChild(0)->getStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D(image));
}

TEST_F(PmPlugin, KeepsAnImageAsTheFileThatItCameFrom)
{
    const std::string png = (_folder / "noise.png").string(), file = (_folder / "ball.pm").string();
    ASSERT_TRUE(osgDB::writeImageFile(*noise(64, GL_RGB), png));
    const osg::ref_ptr<osg::Group> group = model();
    const osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(png);
    setImage(*group, image);
    ASSERT_TRUE(osgDB::writeNodeFile(*group, file));
    EXPECT_NE(testsupport::bytesOf(file).find(testsupport::bytesOf(png)), std::string::npos);
    EXPECT_EQ(image->s(), 64) << "the model's own image is as it was";
    const auto back = readBack(file);
    ASSERT_TRUE(back && imageOf(*back));
    EXPECT_EQ(imageOf(*back)->compare(*image), 0);

    // Once the file shows something else, the image itself counts.
    ASSERT_TRUE(osgDB::writeImageFile(*noise(32, GL_RGB), png));
    ASSERT_TRUE(osgDB::writeNodeFile(*group, file));
    EXPECT_EQ(testsupport::bytesOf(file).find(testsupport::bytesOf(png)), std::string::npos);
    ASSERT_TRUE(imageOf(*readBack(file)));
    EXPECT_EQ(imageOf(*readBack(file))->compare(*image), 0);
}

TEST_F(PmPlugin, KeepsImagesOfAnyFormatAsTheyAre)
{
    const std::string file = (_folder / "ball.pm").string();
    const osg::ref_ptr<osg::Image> floats = new osg::Image;
    floats->allocateImage(5, 3, 1, GL_RGBA, GL_FLOAT, 1);
    for (unsigned i = 0; i < floats->getTotalSizeInBytes() / 4; ++i)
        reinterpret_cast<float*>(floats->data())[i] = 0.1F * static_cast<float>(i);
    for (const osg::ref_ptr<osg::Image>& image :
         {floats, noise(8, GL_LUMINANCE), noise(8, GL_LUMINANCE_ALPHA), noise(8, GL_RGBA)})
    {
        const osg::ref_ptr<osg::Group> group = model();
        setImage(*group, image);
        ASSERT_TRUE(osgDB::writeNodeFile(*group, file));
        const auto back = readBack(file);
        ASSERT_TRUE(back && imageOf(*back)) << image->getPixelFormat();
        ASSERT_EQ(imageOf(*back)->s(), image->s());
        for (int t = 0; t < image->t(); ++t)
            for (int s = 0; s < image->s(); ++s)
                ASSERT_EQ(imageOf(*back)->getColor(s, t), image->getColor(s, t)) << image->getPixelFormat();
    }
}

TEST_F(PmPlugin, ShowsTheBeginningOfAFileAsACoarserModel)
{
    const std::string file = (_folder / "ball.pm").string(), cut = (_folder / "cut.pm").string();
    const osg::ref_ptr<osg::Group> group = model();
    setImage(*group, noise(512, GL_RGB));
    ASSERT_TRUE(osgDB::writeNodeFile(*group, file));
    const std::string bytes = testsupport::bytesOf(file);
    const std::uint32_t whole = readBack(file)->shape()->progressive().stepCount;
    const std::size_t base = bytes.find("BASE"), image = bytes.find("IMAG");
    ASSERT_LT(base, image);
    EXPECT_LT(base, bytes.size() / 50) << "little comes before the coarsest level";
    std::uint32_t last = 0;
    for (const std::size_t size : {bytes.find("STEP") + 3, image + 100, bytes.size() - 1})
    {
        std::ofstream(cut, std::ios::binary) << bytes.substr(0, size);
        const auto node = readBack(cut);
        ASSERT_TRUE(node) << size;
        ASSERT_EQ(node->getNumDescriptions(), 1u);
        EXPECT_THAT(node->getDescription(0), testing::HasSubstr("the file is cut off"));
        EXPECT_THAT(node->getDescription(0), testing::HasSubstr("of " + std::to_string(whole) + " steps"));
        EXPECT_GE(node->shape()->progressive().stepCount, last);
        last = node->shape()->progressive().stepCount;
        const auto shown = imageOf(*node);
        ASSERT_TRUE(shown);
        if (shown->s() == 512) continue;
        EXPECT_THAT(node->getDescription(0), testing::HasSubstr("without 1 image"));
        EXPECT_NEAR(shown->getColor(0, 0).x(), 0.5, 0.02) << "the mean colour";
    }
    EXPECT_EQ(last, whole);
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, base + 20);
    EXPECT_FALSE(readBack(cut)) << "without its coarsest level it is no model";
}

TEST_F(PmPlugin, RefusesAnEmptyNode)
{
    const std::string file = (_folder / "nothing.pm").string();
    const osg::ref_ptr<osg::Group> nothing = new osg::Group;
    EXPECT_FALSE(osgDB::writeNodeFile(*nothing, file));
    EXPECT_FALSE(std::filesystem::exists(file));
}

} // namespace
