// SPDX-License-Identifier: Apache-2.0
// The gain of polishing by images, measured in images of OSG: another renderer, other directions and another
// projection than those of the polishing.
#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/MaterialLooks>
#include <osgPMObjects/ReadModel>

#include "RealData.h"
#include "RenderedError.h"
#include "RenderedModel.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects;
using core::Mesh;

/// A ball with bumps and smooth normals, and a hidden smaller ball inside.
Mesh bumpyBallAroundAnother()
{
    Mesh ball = testsupport::meshOf(testsupport::sphereMesh(40, 60));
    for (glm::dvec3& p : ball.positions)
        p *= 1.0 + 0.12 * std::sin(4.0 * p.x + 1.0) * std::cos(5.0 * p.y) + 0.1 * std::sin(7.0 * p.z);
    ball = testsupport::together(ball, testsupport::meshOf(testsupport::sphereMesh(20, 30)), {});
    for (std::size_t i = 40 * 60; i < ball.positions.size(); ++i)
        ball.positions[i] *= 0.4;
    return testsupport::lit(std::move(ball));
}

struct Errors
{
    double quadrics = 0.0, polished = 0.0;
};

/// The image errors of two levels with the same number of faces.
Errors errorsOf(const core::Mesh& mesh, std::span<const osg::ref_ptr<osg::StateSet>> states,
                std::size_t faces, const core::PolishSettings& settings)
{
    const auto studio = rendered::ModelStudio::open(320, 240);
    if (!studio) return {};
    const core::CollapseSequence quadrics = core::simplify(mesh, settings.simplify);
    const Mesh level = core::meshAfter(mesh, quadrics, core::stepsToFaces(quadrics, faces));
    const core::CollapseSequence polished =
        core::polishByImages(mesh, quadrics, level.faces.size(), materialLooks(mesh, states), settings);
    EXPECT_TRUE(core::isSequenceOf(polished, mesh));
    const Mesh better = core::meshAfter(mesh, polished, core::stepsToFaces(polished, level.faces.size()));
    EXPECT_TRUE(core::isValid(better));
    EXPECT_LE(better.faces.size(), level.faces.size());
    EXPECT_GE(better.faces.size() + 4, level.faces.size());
    const auto original = exportNode(mesh, states);
    const osg::BoundingSphere ball = original->getBound();
    const auto pictures = [&](const Mesh& m) { return studio->pictures(*exportNode(m, states), ball); };
    const auto reference = pictures(mesh);
    return {rendered::imageError(reference, pictures(level)),
            rendered::imageError(reference, pictures(better))};
}

TEST(PolishedPictures, AreATenthNearerThanThoseOfQuadrics)
{
    const Mesh mesh = bumpyBallAroundAnother();
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    state->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    const std::vector states{state};
    for (const auto placement : {core::Placement::subset, core::Placement::optimal})
        for (const std::size_t faces : {400u, 120u})
        {
            core::PolishSettings settings{.simplify = {.placement = placement}};
            const Errors errors = errorsOf(mesh, states, faces, settings);
            EXPECT_LT(errors.polished, 0.9 * errors.quadrics) << faces;
            EXPECT_GT(errors.polished, 0.0);
            settings.views = 0; // without images there is no gain
            settings.moveRounds = 0;
            const Errors blind = errorsOf(mesh, states, faces, settings);
            EXPECT_GT(blind.polished, 0.9 * blind.quadrics) << faces;
        }
}

class RealPolishedPictures : public testing::TestWithParam<const char*>
{
};

TEST_P(RealPolishedPictures, AreATenthNearerThanThoseOfQuadrics)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    const auto node = readModelNode(file);
    ASSERT_TRUE(node) << node.error().message();
    auto model = importNode(**node, file.string());
    ASSERT_TRUE(model) << model.error().message();
    core::consolidate(model->mesh);
    core::weldPositions(model->mesh, 0.0);
    core::mergeWedges(model->mesh);
    const core::PolishSettings settings;
    const Errors errors = errorsOf(model->mesh, model->states, model->mesh.faces.size() / 20, settings);
    EXPECT_LT(errors.polished, 0.9 * errors.quadrics);
}

INSTANTIATE_TEST_SUITE_P(Models, RealPolishedPictures,
                         testing::Values("aircraft/KC-130.ac", "aircraft/cessna.obj", "cad/club.obj"),
                         [](const auto& parameter)
                         {
                             const std::string name = parameter.param;
                             const std::size_t from = name.find('/') + 1;
                             std::string stem = name.substr(from, name.find('.') - from);
                             std::erase(stem, '-');
                             return stem;
                         });

/// The measure on images made by hand.
TEST(PolishedPicturesJudge, IsTheRootMeanSquareOverWhatIsCovered)
{
    const auto picture = [](unsigned char level)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
        std::fill_n(image->data(), 12, static_cast<unsigned char>(0));
        std::fill_n(image->data(1, 1), 3, level);
        return image;
    };
    EXPECT_EQ(rendered::imageError(*picture(0), *picture(0)), 0.0);
    EXPECT_EQ(rendered::imageError(*picture(255), *picture(255)), 0.0);
    EXPECT_NEAR(rendered::imageError(*picture(255), *picture(0)), 1.0, 1e-12);
    EXPECT_NEAR(rendered::imageError(*picture(102), *picture(51)), 0.2, 1e-12);
}

} // namespace
