// SPDX-License-Identifier: Apache-2.0
// Real models, drawn before and after: import and export do not change images, and consolidation does not
// where there was no defect.
#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/order/TriangleStrips.h>

#include <osgOffscreen/ImageComparison>
#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ReadModel>

#include "RealData.h"
#include "RenderedModel.h"

namespace
{

using namespace osgPMObjects;

constexpr const char* kModels[] = {"aircraft/KC-130.ac",
                                   "aircraft/a4-f-tanker.ac",
                                   "aircraft/cessna.obj",
                                   "building/coolingtower.ac",
                                   "building/hochhaus_asemwald.ac",
                                   "building/lasnamae_korghoone.ac",
                                   "building/zone_maisons-ba.ac",
                                   "cad/2CylinderEngine.glb",
                                   "cad/blob5.obj",
                                   "cad/club.obj",
                                   "cad/spheretext.obj",
                                   "cad/standingblob.obj",
                                   "cad/teapot.obj",
                                   "cad/vintageFan.obj",
                                   "character/pirate.obj",
                                   "character/spider.obj",
                                   "character/spot.obj",
                                   "ship/CG-57.ac.gz",
                                   "ship/vinson.ac",
                                   "tree/eztree_bush_1.obj",
                                   "tree/eztree_oak_medium.obj",
                                   "vehicle/110Bus.ac",
                                   "vehicle/CesiumMilkTruck.obj",
                                   "vehicle/Forklift.ac",
                                   "vehicle/Goldhofert.ac",
                                   "vehicle/ICE3firstcar.ac",
                                   "vehicle/evo_wrc.obj",
                                   "vehicle/fox_wrc.obj",
                                   "vehicle/hoskosh-ti-1500.ac"};

osg::ref_ptr<osg::Group> nodeOfModel(const ImportedModel& model)
{
    osg::ref_ptr<osg::Group> root = exportNode(model.mesh, model.states);
    root->addChild(model.remainder);
    return root;
}

/// Returns whether consolidation has nothing to repair, so that it must not change images.
bool isUnbroken(const core::ConsolidateReport& r)
{
    return r.facesDropped() + r.tVertices.inserted + r.tVertices.stitched + r.weldedPositions +
               r.insideOut.turnedGroups + r.facesGivenNormals ==
           0;
}

class ModelPictures : public testing::TestWithParam<const char*>
{
protected:
    /// Renders a node in eight views of a sphere.
    static std::vector<osg::ref_ptr<osg::Image>> picturesOf(osg::Node& node,
                                                            const osg::BoundingSphere& sphere)
    {
        static const std::unique_ptr<rendered::ModelStudio> studio = rendered::ModelStudio::open();
        if (studio) return studio->pictures(node, sphere);
        ADD_FAILURE() << "no context";
        return {};
    }

    static void expectSame(const std::vector<osg::ref_ptr<osg::Image>>& before,
                           const std::vector<osg::ref_ptr<osg::Image>>& after, const char* what)
    {
        ASSERT_FALSE(before.empty());
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t i = 0; i < before.size(); ++i)
        {
            const auto difference = osgOffscreen::compareImages(*before[i], *after[i]);
            EXPECT_TRUE(difference.within(16, 1))
                << GetParam() << ' ' << what << ", direction " << i << ": " << difference.message();
        }
    }
};

TEST_P(ModelPictures, StayTheSame)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    const auto node = readModelNode(file);
    ASSERT_TRUE(node) << node.error().message();
    auto model = importNode(**node, file.string());
    ASSERT_TRUE(model) << model.error().message();
    const osg::BoundingSphere sphere = (*node)->getBound();
    const auto original = picturesOf(**node, sphere);
    expectSame(original, picturesOf(*nodeOfModel(*model), sphere), "imported");
    const core::ConsolidateReport report = core::consolidate(model->mesh);
    const core::MeshCounts after = core::countMesh(model->mesh);
    EXPECT_EQ(after.tJunctions + after.duplicates + after.degenerates + after.nonManifoldEdges, 0u);
    if (isUnbroken(report)) expectSame(original, picturesOf(*nodeOfModel(*model), sphere), "consolidated");
}

INSTANTIATE_TEST_SUITE_P(Real, ModelPictures, testing::ValuesIn(kModels), testsupport::AfterFile());

/// Models without anything transparent, whose order does not show.
constexpr const char* kOpaque[] = {"cad/standingblob.obj", "character/spot.obj", "vehicle/Forklift.ac"};

class StripPictures : public ModelPictures
{
protected:
    static StripMaker stripsBy(core::StripKind kind)
    {
        return [kind](std::span<const core::Triangle> triangles, std::uint32_t vertexCount)
        { return core::joinStrips(triangles, core::stripsOf(triangles, vertexCount, kind)); };
    }
};

TEST_P(StripPictures, OfStripsAreThoseOfTriangles)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    const auto node = readModelNode(file);
    ASSERT_TRUE(node) << node.error().message();
    auto model = importNode(**node, file.string());
    ASSERT_TRUE(model) << model.error().message();
    core::consolidate(model->mesh);
    const osg::BoundingSphere sphere = (*node)->getBound();
    const auto triangles = picturesOf(*exportNode(model->mesh, model->states), sphere);
    for (const core::StripKind kind : {core::StripKind::sgi, core::StripKind::dualGraph})
        expectSame(triangles, picturesOf(*exportNode(model->mesh, model->states, stripsBy(kind)), sphere),
                   "strips");
    core::Mesh less = model->mesh;
    less.faces.resize(less.faces.size() * 9 / 10);
    const auto pictures =
        picturesOf(*exportNode(less, model->states, stripsBy(core::StripKind::sgi)), sphere);
    bool isSeen = false;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        isSeen = isSeen || !osgOffscreen::compareImages(*pictures[i], *triangles[i]).within(16, 1);
    EXPECT_TRUE(isSeen) << "a tenth of the faces is missing";
}

INSTANTIATE_TEST_SUITE_P(Real, StripPictures, testing::ValuesIn(kOpaque), testsupport::AfterFile());

/// The comparison above can fail: a missing face is found.
TEST(ModelPicturesMutation, AFaceLessIsSeen)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "models/vehicle/110Bus.ac");
    const auto node = readModelNode(file);
    ASSERT_TRUE(node);
    auto model = importNode(**node, file.string());
    ASSERT_TRUE(model);
    std::size_t largest = 0;
    double most = 0.0;
    for (std::size_t f = 0; f < model->mesh.faces.size(); ++f)
    {
        const core::Face& face = model->mesh.faces[f];
        const auto& at = model->mesh;
        const double area =
            glm::length(glm::cross(at.at(face, 1) - at.at(face, 0), at.at(face, 2) - at.at(face, 0)));
        if (area > most) most = area, largest = f;
    }
    model->mesh.faces.erase(model->mesh.faces.begin() + static_cast<std::ptrdiff_t>(largest));
    const auto studio = rendered::ModelStudio::open();
    ASSERT_TRUE(studio);
    const auto a = studio->pictures(**node, (*node)->getBound());
    const auto b = studio->pictures(*nodeOfModel(*model), (*node)->getBound());
    bool isSeen = false;
    for (std::size_t i = 0; i < a.size(); ++i)
        isSeen = isSeen || !osgOffscreen::compareImages(*a[i], *b[i]).within(16, 1);
    EXPECT_TRUE(isSeen);
}

} // namespace
