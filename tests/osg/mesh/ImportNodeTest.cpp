// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/LOD>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Switch>
#include <osg/Texture2D>

#include <osgPMObjects/core/consolidate/SplitEdges.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ImportNode>

namespace
{

using namespace osgPMObjects;
using core::Material;

/// A unit square in z = 0, front side up, drawn as one quad.
osg::ref_ptr<osg::Geometry> square()
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const osg::Vec3& p :
         {osg::Vec3(0, 0, 0), osg::Vec3(1, 0, 0), osg::Vec3(1, 1, 0), osg::Vec3(0, 1, 0)})
        corners->push_back(p);
    geometry->setVertexArray(corners);
    const osg::Vec3 up(0, 0, 1);
    geometry->setNormalArray(new osg::Vec3Array(1, const_cast<osg::Vec3*>(&up)), osg::Array::BIND_OVERALL);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    return geometry;
}

osg::ref_ptr<osg::MatrixTransform> under(const osg::Matrixd& matrix, osg::Node* child)
{
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(matrix);
    transform->addChild(child);
    return transform;
}

ImportedModel imported(osg::Node& node)
{
    auto model = importNode(node, "test");
    EXPECT_TRUE(model) << model.error().message();
    EXPECT_EQ(core::defectOf(model->mesh), "");
    return model ? *std::move(model) : ImportedModel{};
}

/// Returns twice the area vector of all faces.
glm::dvec3 areaOf(const core::Mesh& mesh)
{
    glm::dvec3 sum(0.0);
    for (const core::Face& f : mesh.faces)
    {
        const glm::dvec3 a = mesh.at(f, 1) - mesh.at(f, 0), b = mesh.at(f, 2) - mesh.at(f, 0);
        sum += glm::dvec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }
    return sum;
}

TEST(ImportNode, ReadsAQuadWithItsOverallNormal)
{
    const ImportedModel model = imported(*square());
    EXPECT_EQ(model.mesh.positions.size(), 4u);
    EXPECT_EQ(model.mesh.faces.size(), 2u);
    EXPECT_EQ(areaOf(model.mesh), glm::dvec3(0, 0, 2));
    EXPECT_EQ(model.mesh.normals.at(3), glm::vec3(0, 0, 1));
    EXPECT_EQ(model.mesh.materials.at(0).attributes, Material::normal);
    EXPECT_EQ(model.report.geometries, 1u);
}

TEST(ImportNode, AppliesTransformsInDoubles)
{
    const auto far = under(osg::Matrixd::translate(6378137.25, 0.0, 0.0),
                           under(osg::Matrixd::rotate(osg::PI_2, osg::Vec3d(1, 0, 0)), square()));
    const ImportedModel model = imported(*far);
    EXPECT_NEAR(model.mesh.positions.at(0).x, 6378137.25, 1e-9);
    EXPECT_NEAR(areaOf(model.mesh).y, -2.0, 1e-9);
    EXPECT_NEAR(model.mesh.normals.at(0).y, -1.0, 1e-6);
}

TEST(ImportNode, AMirroringTransformKeepsFrontsInFront)
{
    const ImportedModel model = imported(*under(osg::Matrixd::scale(-1.0, 1.0, 1.0), square()));
    EXPECT_EQ(areaOf(model.mesh), glm::dvec3(0, 0, 2))
        << "counter-clockwise seen from above, as the quad was";
    EXPECT_EQ(model.mesh.normals.at(0), glm::vec3(0, 0, 1));
}

TEST(ImportNode, NormalsFollowUnevenScaling)
{
    osg::ref_ptr<osg::Geometry> slope = square();
    const osg::Vec3 normal(1, 0, 1);
    slope->setNormalArray(new osg::Vec3Array(1, const_cast<osg::Vec3*>(&normal)), osg::Array::BIND_OVERALL);
    const ImportedModel model = imported(*under(osg::Matrixd::scale(2.0, 1.0, 1.0), slope));
    EXPECT_EQ(model.mesh.normals.at(0), glm::vec3(0.5f, 0.0f, 1.0f)) << "the inverse transpose";
}

TEST(ImportNode, AttributesFollowTheirBindings)
{
    osg::ref_ptr<osg::Geometry> geometry = square();
    geometry->removePrimitiveSet(0);
    const GLushort first[] = {0, 1, 2}, second[] = {0, 2, 3};
    geometry->addPrimitiveSet(new osg::DrawElementsUShort(GL_TRIANGLES, 3, first));
    geometry->addPrimitiveSet(new osg::DrawElementsUShort(GL_TRIANGLES, 3, second));
    osg::ref_ptr<osg::Vec4ubArray> colours = new osg::Vec4ubArray;
    colours->push_back({255, 0, 0, 255});
    colours->push_back({0, 255, 0, 255});
    geometry->setColorArray(colours, osg::Array::BIND_PER_PRIMITIVE_SET);
    osg::ref_ptr<osg::Vec2Array> texCoords = new osg::Vec2Array;
    for (int i = 0; i < 4; ++i)
        texCoords->push_back({0.25f * static_cast<float>(i), 1.0f});
    geometry->setTexCoordArray(1, texCoords, osg::Array::BIND_PER_VERTEX);
    const core::Mesh mesh = imported(*geometry).mesh;
    ASSERT_EQ(mesh.faces.size(), 2u);
    for (int corner = 0; corner < 3; ++corner)
    {
        EXPECT_EQ(mesh.colours[mesh.faces[0].wedges[corner]], glm::vec4(1, 0, 0, 1));
        EXPECT_EQ(mesh.colours[mesh.faces[1].wedges[corner]], glm::vec4(0, 1, 0, 1));
    }
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.wedgeCount(), 6u);
    EXPECT_EQ(mesh.texCoords[1][mesh.faces[1].wedges[2]], glm::vec2(0.75f, 1.0f));
    EXPECT_TRUE(mesh.texCoords[0].empty());
}

TEST(ImportNode, ReadsIndexArraysOfOldFiles)
{
    // As OSG's readers leave it: indices as the array's user data, and a binding that no longer has a name.
    constexpr auto kPerPrimitive = static_cast<osg::Array::Binding>(3);
    osg::ref_ptr<osg::Geometry> old = square();
    osg::ref_ptr<osg::UShortArray> indices = new osg::UShortArray;
    for (const int i : {0, 1, 2, 0, 2, 3})
        indices->push_back(static_cast<GLushort>(i));
    old->getVertexArray()->setUserData(indices);
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    colours->push_back({1, 0, 0, 1});
    colours->push_back({0, 0, 1, 1});
    old->setColorArray(colours, kPerPrimitive);
    old->setPrimitiveSet(0, new osg::DrawArrays(GL_TRIANGLES, 0, 6));
    ASSERT_TRUE(old->checkForDeprecatedData());
    const core::Mesh mesh = imported(*old).mesh;
    EXPECT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.colours[mesh.faces[0].wedges[0]], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.colours[mesh.faces[1].wedges[0]], glm::vec4(0, 0, 1, 1));
    EXPECT_TRUE(old->containsDeprecatedData()) << "what is imported stays as it was";
}

TEST(ImportNode, StatesOfAPathMergeAndEqualOnesAreOneMaterial)
{
    const auto paint = [](float red)
    {
        osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
        osg::ref_ptr<osg::Material> material = new osg::Material;
        material->setDiffuse(osg::Material::FRONT_AND_BACK, {red, 0, 0, 1});
        material->setName("paint");
        state->setAttributeAndModes(material);
        return state;
    };
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->getOrCreateStateSet()->setAttributeAndModes(new osg::CullFace);
    for (const float red : {0.5f, 0.5f, 0.25f})
    {
        const osg::ref_ptr<osg::Geometry> geometry = square();
        geometry->setStateSet(paint(red));
        root->addChild(geometry);
    }
    root->getChild(2)->asDrawable()->getStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    root->getChild(2)->asDrawable()->getStateSet()->setAttributeAndModes(new osg::BlendFunc);
    const ImportedModel model = imported(*root);
    ASSERT_EQ(model.mesh.materials.size(), 2u);
    EXPECT_EQ(model.states.size(), 2u);
    EXPECT_EQ(model.mesh.materials[0].name, "paint");
    EXPECT_FALSE(model.mesh.materials[0].isTwoSided) << "culling comes from the root";
    EXPECT_TRUE(model.mesh.materials[1].isTwoSided);
    EXPECT_TRUE(model.mesh.materials[1].isTransparent);
    EXPECT_FALSE(model.mesh.materials[0].isTransparent);
    EXPECT_NE(model.states[0]->getAttribute(osg::StateAttribute::CULLFACE), nullptr);
}

TEST(ImportNode, TextureCoordinatesAreSeenOnlyWhereThereIsATexture)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (int i = 0; i < 2; ++i)
    {
        const osg::ref_ptr<osg::Geometry> geometry = square();
        geometry->setTexCoordArray(0, new osg::Vec2Array(4), osg::Array::BIND_PER_VERTEX);
        root->addChild(geometry);
    }
    root->getChild(1)->getOrCreateStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D);
    const ImportedModel model = imported(*root);
    ASSERT_EQ(model.mesh.materials.size(), 2u);
    EXPECT_EQ(model.mesh.materials[0].unseen, Material::texCoord0 | Material::texCoord1);
    EXPECT_EQ(model.mesh.materials[1].unseen, Material::texCoord1);
}

TEST(ImportNode, TakesTheFinestLevelAndWhatIsOn)
{
    osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    lod->addChild(under(osg::Matrixd::scale(3, 3, 3), square()), 50.0f, 1000.0f);
    lod->addChild(square(), 0.0f, 50.0f);
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(under(osg::Matrixd::scale(5, 5, 5), square()), false);
    choice->addChild(lod, true);
    const osg::ref_ptr<osg::Geometry> hidden = square();
    hidden->setNodeMask(0);
    choice->addChild(hidden, true);
    const ImportedModel model = imported(*choice);
    EXPECT_EQ(areaOf(model.mesh), glm::dvec3(0, 0, 2));
    EXPECT_EQ(model.report.coarserLevels, 1u);
    EXPECT_EQ(model.report.hiddenChildren, 2u);
}

TEST(ImportNode, KeepsWhatIsNoSurface)
{
    osg::ref_ptr<osg::Geometry> geometry = square();
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_LINE_LOOP, 0, 4));
    const ImportedModel model = imported(*under(osg::Matrixd::translate(7, 0, 0), geometry));
    EXPECT_EQ(model.mesh.faces.size(), 2u);
    EXPECT_EQ(model.report.keptDrawables, 1u);
    ASSERT_EQ(model.remainder->getNumChildren(), 1u);
    EXPECT_NEAR(model.remainder->getBound().center().x(), 7.5f, 1e-5f);
    const osg::Geometry* lines =
        model.remainder->getChild(0)->asGroup()->getChild(0)->asDrawable()->asGeometry();
    EXPECT_EQ(lines->getPrimitiveSet(0)->getNumIndices(), 0u) << "the quad is in the mesh";
    EXPECT_EQ(lines->getPrimitiveSet(1)->getNumIndices(), 4u);
}

TEST(ImportNode, RefusesAndCountsWhatPointsNowhereOrIsNoNumber)
{
    osg::ref_ptr<osg::Geometry> geometry = square();
    const GLushort beyond[] = {0, 1, 4};
    geometry->addPrimitiveSet(new osg::DrawElementsUShort(GL_TRIANGLES, 3, beyond));
    ImportedModel model = imported(*geometry);
    EXPECT_EQ(model.report.refusedFaces, 1u);
    EXPECT_EQ(model.mesh.faces.size(), 2u);

    (*static_cast<osg::Vec3Array*>(geometry->getVertexArray()))[3].x() =
        std::numeric_limits<float>::quiet_NaN();
    model = imported(*geometry);
    EXPECT_EQ(model.report.refusedFaces, 3u);

    osg::ref_ptr<osg::Geometry> bent = square();
    const osg::Vec3 infinite(0, 0, std::numeric_limits<float>::infinity());
    bent->setNormalArray(new osg::Vec3Array(1, const_cast<osg::Vec3*>(&infinite)), osg::Array::BIND_OVERALL);
    model = imported(*bent);
    EXPECT_EQ(model.report.zeroedAttributes, 4u);
    EXPECT_EQ(model.mesh.faces.size(), 2u);
}

TEST(ImportNode, RefusesAGraphWithoutEnd)
{
    osg::ref_ptr<osg::Group> top = new osg::Group;
    osg::ref_ptr<osg::Group> inner = top;
    for (int i = 0; i < 5000; ++i)
    {
        const osg::ref_ptr<osg::Group> next = new osg::Group;
        inner->addChild(next);
        inner = next;
    }
    const auto model = importNode(*top, "deep.osgt");
    ASSERT_FALSE(model);
    EXPECT_TRUE(model.error().message().starts_with("deep.osgt: nodes are nested deeper"))
        << model.error().message();
}

/// A model with all that a mesh can have, for export and import.
osg::ref_ptr<osg::Group> variousModel()
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (int i = 0; i < 3; ++i)
    {
        const osg::ref_ptr<osg::Geometry> geometry = square();
        geometry->setName("part " + std::to_string(i));
        osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
        for (int c = 0; c < 4; ++c)
            colours->push_back({0.25f * static_cast<float>(c), 0.5f, 1.0f, 1.0f});
        if (i != 1) geometry->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
        if (i == 2) geometry->setTexCoordArray(0, new osg::Vec2Array(4), osg::Array::BIND_PER_VERTEX);
        root->addChild(under(osg::Matrixd::translate(0.0, 0.0, i), geometry));
    }
    return root;
}

TEST(ExportNode, IsTheInverseOfTheImport)
{
    for (const double far : {0.0, 4.2e6})
    {
        const ImportedModel before = imported(*under(osg::Matrixd::translate(far, 0, 0), variousModel()));
        const ImportedModel after = imported(*exportNode(before.mesh, before.states));
        EXPECT_EQ(after.mesh.positions, before.mesh.positions) << far;
        EXPECT_EQ(after.mesh.faces, before.mesh.faces);
        EXPECT_EQ(after.mesh.wedgePositions, before.mesh.wedgePositions);
        EXPECT_EQ(after.mesh.normals, before.mesh.normals);
        EXPECT_EQ(after.mesh.colours, before.mesh.colours);
        EXPECT_EQ(after.mesh.materials, before.mesh.materials);
        EXPECT_EQ(after.mesh.parts, before.mesh.parts);
    }
}

/// Four squares in pairs around an edge: the copies of its ends are one vertex each.
TEST(ExportNode, CopiesOfPositionsShareVerticesWhereNothingTellsThemApart)
{
    core::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}};
    for (const glm::dvec3& out : {glm::dvec3(1, 0, 0), {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}})
        mesh.positions.push_back(out);
    for (std::uint32_t i = 0; i < 6; ++i)
        mesh.wedgePositions.push_back(i);
    mesh.faces = {{{0, 1, 2}, 0, 0}, {{1, 0, 3}, 0, 0}, {{0, 1, 4}, 0, 0}, {{1, 0, 5}, 0, 0}};
    mesh.materials.push_back({.name = "material"});
    mesh.parts.push_back({"part"});
    ASSERT_EQ(core::splitNonManifoldEdges(mesh).copies, 2u);
    const auto verticesOf = [](const core::Mesh& of)
    {
        const auto node = exportNode(of, {});
        return node->getChild(0)->asGeode()->getDrawable(0)->asGeometry()->getVertexArray()->getNumElements();
    };
    EXPECT_EQ(verticesOf(mesh), 6u);
    mesh.normals.assign(mesh.wedgeCount(), {0.0f, 0.0f, 1.0f});
    mesh.normals[mesh.faces[3].wedges[0]] = {1.0f, 0.0f, 0.0f};
    mesh.materials[0].attributes = Material::normal;
    EXPECT_EQ(verticesOf(mesh), 7u) << "another normal is another vertex";
}

} // namespace
