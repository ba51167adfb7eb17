// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/ComputeBoundsVisitor>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/MakeProgressive>

#include "HandCull.h"
#include "ProgressiveSubject.h"
#include "RealData.h"
#include "RealProgressive.h"

namespace
{

using namespace progressive;
using handcull::cameraAt;
using handcull::cull;

osg::ref_ptr<osg::Geode> ballOf(float x, osg::StateSet* state)
{
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(new osg::ShapeDrawable(new osg::Sphere({x, 0.0F, 0.0F}, 1.0F)));
    geode->setStateSet(state);
    return geode;
}

osg::ref_ptr<osg::Geometry> lineOf()
{
    const osg::ref_ptr<osg::Geometry> line = new osg::Geometry;
    const osg::ref_ptr<osg::Vec3Array> ends = new osg::Vec3Array;
    ends->push_back({0.0F, 0.0F, 0.0F});
    ends->push_back({0.0F, 0.0F, 9.0F});
    line->setVertexArray(ends);
    line->addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, 2));
    return line;
}

osg::ref_ptr<osg::StateSet> stateOf(const char* name)
{
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setName(name);
    material->setDiffuse(osg::Material::FRONT_AND_BACK, {name[0] / 255.0F, 0.5F, 0.2F, 1.0F});
    state->setAttributeAndModes(material);
    return state;
}

std::vector<osg::ref_ptr<osg::Drawable>> drawablesOf(osg::Group& group)
{
    std::vector<osg::ref_ptr<osg::Drawable>> drawables;
    for (unsigned i = 0; i < group.getNumChildren(); ++i)
        drawables.push_back(group.getChild(i)->asGroup()->getChild(0)->asDrawable());
    return drawables;
}

} // namespace

TEST(MakeProgressive, TakesAllSurfacesWithTheirStatesAndKeepsTheRest)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->setName("scene");
    scene->addChild(ballOf(0.0F, stateOf("red")));
    const osg::ref_ptr<osg::MatrixTransform> place =
        new osg::MatrixTransform(osg::Matrixd::translate(5.0, 0.0, 0.0));
    place->addChild(ballOf(0.0F, stateOf("green")));
    place->addChild(lineOf());
    scene->addChild(place);
    const auto model = makeProgressive(*scene);
    ASSERT_TRUE(model) << model.error().message();
    const ProgressiveNode& node = *model->node;
    EXPECT_EQ(node.getName(), "scene");
    EXPECT_EQ(model->report.keptDrawables, 1u);
    ASSERT_EQ(node.getNumChildren(), 2u) << "the drawable, and what is no surface";
    ASSERT_EQ(node.shape()->groups().size(), 2u);
    EXPECT_FALSE(node.shape()->levels().measured.isEmpty()) << "errors are measured";
    std::vector<std::string> names;
    for (const auto& group : node.shape()->groups())
        names.push_back(group.state->getAttribute(osg::StateAttribute::MATERIAL)->getName());
    EXPECT_EQ(names, (std::vector<std::string>{"red", "green"}));
    osg::ComputeBoundsVisitor bounds;
    model->node->accept(bounds);
    EXPECT_NEAR(bounds.getBoundingBox().xMin(), -1.0, 0.1);
    EXPECT_NEAR(bounds.getBoundingBox().xMax(), 6.0, 0.1) << "a transform above is applied";
    EXPECT_NEAR(bounds.getBoundingBox().zMax(), 9.0, 0.1) << "the line is still there";
    const auto culled = cull(*model->node, *cameraAt({2.0, -8.0, 1.0}, {2.0, 0.0, 0.0}), 1);
    EXPECT_EQ(culled.drawables.size(), 3u);
}

TEST(MakeProgressive, SaysWhatIsWrongWithWhatHasNoSurfaces)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    const auto nothing = makeProgressive(*scene, "empty.osgt");
    ASSERT_FALSE(nothing);
    EXPECT_NE(nothing.error().message().find("empty.osgt"), std::string::npos);
    scene->addChild(lineOf());
    EXPECT_FALSE(makeProgressive(*scene));
}

TEST(BakeLevel, HasTheTrianglesThatAreDrawnAtThatLevel)
{
    const Subject subject = torusAndSheet();
    for (std::uint32_t steps = 0; steps < subject.sequence.steps.size(); steps += 97)
    {
        const osg::ref_ptr<osg::Group> baked = bakeLevel(*subject.shape, steps);
        EXPECT_EQ(trianglesOf(drawablesOf(*baked)),
                  trianglesOf(core::meshAfter(subject.mesh, subject.sequence, steps)));
    }
    EXPECT_EQ(bakeLevel(*subject.shape, ~0u)->getNumChildren(),
              bakeLevel(*subject.shape, subject.shape->progressive().stepCount)->getNumChildren())
        << "more steps than there are lead to the coarsest level";
}

class ProgressiveModels : public testing::TestWithParam<const char*>
{
};

TEST_P(ProgressiveModels, AreDrawnAtAnyLevelAsItsMeshIs)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    const auto real = RealProgressive::of(file);
    ASSERT_TRUE(real);
    ProgressiveNode& node = real->node();
    const ProgressiveShape& shape = real->shape();
    ASSERT_TRUE(core::isLevelTable(shape.levels()));
    const osg::BoundingSphere ball = node.getBound();
    const auto camera = cameraAt(ball.center() + osg::Vec3d(0.0, -3.0 * ball.radius(), 0.0), ball.center());
    unsigned frame = 0;
    for (const unsigned eighths : {0, 3, 8, 6, 1, 0})
    {
        const std::uint32_t steps = shape.progressive().stepCount * eighths / 8;
        EXPECT_TRUE(node.drawable()->setSteps(steps));
        const auto culled = cull(*node.drawable(), *camera, ++frame);
        const osg::ref_ptr<osg::Group> baked = bakeLevel(shape, steps);
        EXPECT_EQ(trianglesOf(culled.drawables), trianglesOf(drawablesOf(*baked))) << eighths;
        const auto& faces = shape.levels().faces; // ends where no face is left
        EXPECT_EQ(culled.triangles(), steps < faces.size() ? faces[steps] : 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Real, ProgressiveModels,
                         testing::Values("aircraft/cessna.obj", "vehicle/110Bus.ac", "character/spot.obj"),
                         testsupport::AfterFile());
