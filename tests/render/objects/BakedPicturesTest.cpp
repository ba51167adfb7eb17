// SPDX-License-Identifier: Apache-2.0
// Simplified models with and without baked maps: how much their images differ from those of the full model.
#include <sstream>

#include <gtest/gtest.h>

#include <osg/Image>
#include <osg/Program>
#include <osg/Texture2D>
#include <osgDB/Registry>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgPMObjects/BakeModel>
#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ReadModel>

#include "RealData.h"
#include "RenderedError.h"
#include "RenderedModel.h"
#include "RoundMeshes.h"

namespace
{

using namespace osgPMObjects;

/// Makes rings of colour around the poles of a ball, twelve in a texture.
osg::ref_ptr<osg::StateSet> ringedState()
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(4, 256, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int t = 0; t < 256; ++t)
        for (int s = 0; s < 4; ++s)
        {
            unsigned char* texel = image->data(s, t);
            texel[0] = static_cast<unsigned char>(128.0 + 100.0 * std::sin(0.295 * t));
            texel[1] = static_cast<unsigned char>(t);
            texel[2] = 180;
        }
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    state->setTextureAttributeAndModes(0, texture);
    return state;
}

/// A ball with bumps all over and rings of colour.
ImportedModel bumpyBall()
{
    ImportedModel model;
    model.mesh = testsupport::roundMesh(128, 64, testsupport::onBumps);
    model.states = {ringedState()};
    model.remainder = new osg::Group;
    return model;
}

core::Mesh simplified(core::Mesh mesh, std::size_t faces)
{
    core::weldPositions(mesh, 0.0);
    const core::CollapseSequence sequence = core::simplify(mesh, {.placement = core::Placement::optimal});
    return core::meshAfter(mesh, sequence, core::stepsToFaces(sequence, faces));
}

osg::ref_ptr<osg::Group> nodeOf(const ImportedModel& model)
{
    osg::ref_ptr<osg::Group> root = exportNode(model.mesh, model.states);
    root->addChild(model.remainder);
    return root;
}

class BakedPictures : public testing::Test
{
protected:
    void SetUp() override { ASSERT_TRUE(studio()); }

    static rendered::ModelStudio* studio()
    {
        static const std::unique_ptr<rendered::ModelStudio> one = rendered::ModelStudio::open();
        return one.get();
    }

    static double error(const ImportedModel& full, osg::Node& shown)
    {
        const osg::ref_ptr<osg::Group> truth = nodeOf(full);
        return rendered::silhouetteError(studio()->pictures(*truth, truth->getBound()),
                                         studio()->pictures(shown, truth->getBound()));
    }

    static ImportedModel bakedOf(const ImportedModel& full, const core::Mesh& level)
    {
        auto baked = bakeModel(full, level, {.charts = {}, .atlas = {.sizePx = 512}, .maps = {}});
        EXPECT_TRUE(baked) << baked.error().message();
        return baked ? baked->model : ImportedModel();
    }
};

/// The ball, a twentieth of its faces, and the image error of these without maps.
class BakedBall : public BakedPictures
{
protected:
    void SetUp() override
    {
        BakedPictures::SetUp();
        static const ImportedModel ball = bumpyBall();
        static const core::Mesh level = simplified(ball.mesh, ball.mesh.faces.size() / 20);
        full = ball;
        bare = ball;
        bare.mesh = level;
        bareError = error(full, *nodeOf(bare));
    }

    ImportedModel full, bare;
    double bareError = 0.0;
};

TEST_F(BakedBall, IsNearerToTheFullModel)
{
    EXPECT_LT(error(full, *nodeOf(bakedOf(full, bare.mesh))), 0.7 * bareError);
}

TEST_F(BakedBall, WithoutShadersIsNoFartherAway)
{
    const osg::ref_ptr<osg::Group> fixed = nodeOf(bakedOf(full, bare.mesh));
    fixed->getOrCreateStateSet()->setAttribute(new osg::Program,
                                               osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    EXPECT_LT(error(full, *fixed), 1.02 * bareError);
}

TEST_F(BakedBall, ReadAgainFromItsFileIsTheSame)
{
    const osg::ref_ptr<osg::Group> node = nodeOf(bakedOf(full, bare.mesh));
    const auto format = osgDB::Registry::instance()->getReaderWriterForExtension("osgb");
    std::stringstream stream;
    ASSERT_TRUE(format->writeNode(*node, stream, new osgDB::Options("WriteImageHint=IncludeData")).success());
    const osg::ref_ptr<osg::Node> again = format->readNode(stream).getNode();
    ASSERT_TRUE(again);
    EXPECT_EQ(rendered::silhouetteError(studio()->pictures(*node, node->getBound()),
                                        studio()->pictures(*again, node->getBound())),
              0.0);
}

TEST_F(BakedBall, MutationNormalsOfAnotherSideAreSeen)
{
    const ImportedModel baked = bakedOf(full, bare.mesh);
    auto* normals =
        dynamic_cast<osg::Texture2D*>(baked.states[0]->getTextureAttribute(1, osg::StateAttribute::TEXTURE));
    ASSERT_TRUE(normals);
    osg::Image& image = *normals->getImage();
    for (unsigned i = 0; i < image.getTotalSizeInBytes(); i += 3)
        std::swap(image.data()[i], image.data()[i + 1]);
    EXPECT_GT(error(full, *nodeOf(baked)), bareError);
}

TEST_F(BakedBall, MutationColoursOfAnotherPlaceAreSeen)
{
    ImportedModel turned = full;
    for (glm::vec2& place : turned.mesh.texCoords[0])
        place.y = 1.0f - place.y;
    EXPECT_GT(error(full, *nodeOf(bakedOf(turned, bare.mesh))), bareError);
}

/// A real model, and the least part of the bare level's error that the maps have to remove.
struct RealCase
{
    const char* file;
    double most;
};

class RealBakedPictures : public BakedPictures, public testing::WithParamInterface<RealCase>
{
};

TEST_P(RealBakedPictures, AreNearerToTheFullModel)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam().file);
    const auto node = readModelNode(file);
    ASSERT_TRUE(node) << node.error().message();
    auto full = importNode(**node, file.string());
    ASSERT_TRUE(full) << full.error().message();
    core::consolidate(full->mesh);
    ImportedModel bare = *full;
    bare.mesh = simplified(full->mesh, full->mesh.faces.size() / 10);
    EXPECT_LT(error(*full, *nodeOf(bakedOf(*full, bare.mesh))),
              GetParam().most * error(*full, *nodeOf(bare)));
}

INSTANTIATE_TEST_SUITE_P(Real, RealBakedPictures,
                         testing::Values(RealCase{"cad/club.obj", 0.85}, RealCase{"character/spot.obj", 0.8},
                                         RealCase{"cad/standingblob.obj", 0.85},
                                         RealCase{"aircraft/cessna.obj", 0.9},
                                         RealCase{"character/pirate.obj", 0.93}),
                         [](const auto& parameter)
                         {
                             const std::string file = parameter.param.file;
                             const std::size_t slash = file.find('/');
                             return file.substr(slash + 1, file.find('.') - slash - 1);
                         });

} // namespace
