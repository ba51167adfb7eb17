// SPDX-License-Identifier: Apache-2.0
// Draws are counted as OpenGL has them: a geometry's primitive sets each, and what a drawable says of itself.
#include "view/DrawCounts.h"

#include <gtest/gtest.h>

#include <osg/Geometry>
#include <osgUtil/RenderLeaf>
#include <osgUtil/StateGraph>

#include <osgTraversal/DrawCount>

namespace
{

class Threefold : public osg::Drawable, public osgTraversal::DrawCount
{
public:
    unsigned int draws() const override { return 3; }
};

void add(osgUtil::StateGraph& graph, osg::Drawable* drawable)
{
    graph.addLeaf(new osgUtil::RenderLeaf(drawable, nullptr, nullptr));
}

} // namespace

TEST(DrawCounts, AreThoseOfOpenGl)
{
    const osg::ref_ptr<osgUtil::StateGraph> graph = new osgUtil::StateGraph;
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 3, 3));
    add(*graph, geometry);
    add(*graph, new Threefold);
    add(*graph, new osg::Drawable);
    const osg::ref_ptr<osgUtil::RenderBin> bin = new osgUtil::RenderBin;
    bin->addStateGraph(graph);
    EXPECT_EQ(trainer::drawsOf(*bin), 6U);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 6, 3));
    EXPECT_EQ(trainer::drawsOf(*bin), 7U);

    const osg::ref_ptr<osgUtil::RenderStage> picture = new osgUtil::RenderStage,
                                             map = new osgUtil::RenderStage;
    map->addStateGraph(graph);
    EXPECT_EQ(trainer::drawsBefore(*picture), 0U);
    picture->addPreRenderStage(map);
    EXPECT_EQ(trainer::drawsBefore(*picture), 7U);
    EXPECT_EQ(trainer::drawsOf(*picture), 0U) << "those before are not its own";
}
