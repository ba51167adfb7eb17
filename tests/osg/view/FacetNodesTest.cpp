// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/FacetNodes.h"

#include <gtest/gtest.h>

#include <osg/Geometry>
#include <osgUtil/GLObjectsVisitor>

namespace
{

/// Counts the drawables that a visitor of a kind comes to.
template<class Visitor>
struct Counting : Visitor
{
    using Visitor::apply;
    int drawables = 0;

    Counting() { this->setTraversalMode(osg::NodeVisitor::TRAVERSE_ALL_CHILDREN); }
    void apply(osg::Drawable&) override { ++drawables; }
    void apply(osg::Geometry&) override { ++drawables; }
};

/// A triangle in a range of distances, and one up to a distance.
osg::ref_ptr<osg::Group> twoTriangles()
{
    scenery::Facets facets;
    facets.addPolygon({{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}}, {{}, {}, {}},
                      glm::vec3(1.0F));
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    scenery::addRange(*root, {10.0, 0.0, 0.0}, 0.0, 100.0).addChild(scenery::geometryOf(facets));
    scenery::addOverlapping(*root, {20.0, 0.0, 0.0}, 100.0).addChild(scenery::geometryOf(facets));
    return root;
}

} // namespace

TEST(FacetNodes, TheDriverIsGivenNothingBeforeItIsDrawn)
{
    const osg::ref_ptr<osg::Group> root = twoTriangles();
    Counting<osg::NodeVisitor> every;
    root->accept(every);
    EXPECT_EQ(every.drawables, 2);
    Counting<osgUtil::GLObjectsVisitor> compiling;
    root->accept(compiling);
    EXPECT_EQ(compiling.drawables, 0);
    // As such a visitor does elsewhere: the count can fail.
    const osg::ref_ptr<osg::Group> plain = new osg::Group;
    plain->addChild(scenery::geometryOf(scenery::Facets()));
    Counting<osgUtil::GLObjectsVisitor> elsewhere;
    plain->accept(elsewhere);
    EXPECT_EQ(elsewhere.drawables, 1);
}

TEST(FacetNodes, AGeometryHasTheCornersAndTrianglesOfItsFacets)
{
    scenery::Facets facets;
    facets.addPolygon({{0.0F, 0.0F, 2.0F}, {1.0F, 0.0F, 2.0F}, {1.0F, 1.0F, 2.0F}, {0.0F, 1.0F, 2.0F}},
                      {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}, {0.2F, 0.4F, 0.6F},
                      {0.1F, 0.2F, 0.3F, 0.4F});
    const auto geometry = scenery::geometryOf(facets);
    const auto& positions = dynamic_cast<const osg::Vec3Array&>(*geometry->getVertexArray());
    const auto& normals = dynamic_cast<const osg::Vec3Array&>(*geometry->getNormalArray());
    const auto& colours = dynamic_cast<const osg::Vec4Array&>(*geometry->getColorArray());
    const auto& uvs = dynamic_cast<const osg::Vec2Array&>(*geometry->getTexCoordArray(0));
    ASSERT_EQ(positions.size(), 4U);
    ASSERT_EQ(uvs.size(), 4U);
    EXPECT_EQ(positions[2], osg::Vec3f(1.0F, 1.0F, 2.0F));
    EXPECT_EQ(normals[1], osg::Vec3f(0.0F, 0.0F, 1.0F));
    EXPECT_EQ(colours[3], osg::Vec4f(0.2F, 0.4F, 0.6F, 0.4F));
    EXPECT_EQ(uvs[2], osg::Vec2f(1.0F, 1.0F));
    EXPECT_EQ(geometry->getPrimitiveSet(0)->getNumIndices(), 6U);

    const auto caster = scenery::casterOf(
        {{scenery::models::Painting::plaster, facets}, {scenery::models::Painting::houseDetails, facets}});
    EXPECT_EQ(caster->getVertexArray()->getNumElements(), 8U);
    EXPECT_EQ(caster->getPrimitiveSet(0)->getNumIndices(), 12U);
    EXPECT_EQ(caster->getPrimitiveSet(0)->index(6), 4U);
}
