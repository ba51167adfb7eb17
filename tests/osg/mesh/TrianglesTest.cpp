// SPDX-License-Identifier: Apache-2.0
#include "import/Triangles.h"

#include <vector>

#include <gtest/gtest.h>

namespace
{

using Corners = std::array<unsigned, 3>;

std::vector<Corners> trianglesOf(const osg::ref_ptr<osg::PrimitiveSet>& set, unsigned vertexCount = 100)
{
    std::vector<Corners> triangles;
    EXPECT_TRUE(
        osgPMObjects::forEachTriangle(*set, vertexCount, [&](const Corners& t) { triangles.push_back(t); }));
    return triangles;
}

std::vector<Corners> ofMode(GLenum mode, int count)
{
    return trianglesOf(new osg::DrawArrays(mode, 0, count));
}

using List = std::vector<Corners>;

TEST(Triangles, EveryModeGivesItsTrianglesAndNoIncompleteOne)
{
    EXPECT_EQ(ofMode(GL_TRIANGLES, 7), (List{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(ofMode(GL_TRIANGLE_STRIP, 5), (List{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
    EXPECT_EQ(ofMode(GL_TRIANGLE_FAN, 5), (List{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    EXPECT_EQ(ofMode(GL_POLYGON, 5), (List{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    EXPECT_EQ(ofMode(GL_QUADS, 7), (List{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(ofMode(GL_QUAD_STRIP, 7), (List{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}}));
    EXPECT_EQ(ofMode(GL_TRIANGLES_ADJACENCY, 12), (List{{0, 2, 4}, {6, 8, 10}}));
    EXPECT_EQ(ofMode(GL_TRIANGLE_STRIP_ADJACENCY, 8), (List{{0, 2, 4}, {4, 2, 6}}));
}

TEST(Triangles, PointsAndLinesAreNoSurfaces)
{
    for (const GLenum mode :
         {GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_LINES_ADJACENCY, GL_PATCHES})
    {
        EXPECT_FALSE(osgPMObjects::isSurface(mode)) << mode;
        EXPECT_TRUE(ofMode(mode, 12).empty()) << mode;
    }
    EXPECT_TRUE(osgPMObjects::isSurface(GL_QUAD_STRIP));
}

TEST(Triangles, StripsGoOnOverDegenerateTrianglesWithTheirWinding)
{
    osg::ref_ptr<osg::DrawElementsUShort> set = new osg::DrawElementsUShort(GL_TRIANGLE_STRIP);
    for (const int i : {0, 1, 2, 2, 5, 5, 6, 7})
        set->push_back(static_cast<GLushort>(i));
    EXPECT_EQ(trianglesOf(set), (List{{0, 1, 2}, {6, 5, 7}})) << "the last is the strip's sixth";
}

TEST(Triangles, EveryKindOfSetKeepsItsIndices)
{
    const GLubyte bytes[] = {9, 4, 7};
    const GLuint words[] = {70000, 4, 7};
    EXPECT_EQ(trianglesOf(new osg::DrawElementsUByte(GL_TRIANGLES, 3, bytes)), (List{{9, 4, 7}}));
    EXPECT_EQ(trianglesOf(new osg::DrawElementsUInt(GL_TRIANGLES, 3, words)), (List{{70000, 4, 7}}));
    EXPECT_EQ(trianglesOf(new osg::DrawArrays(GL_TRIANGLES, 6, 3)), (List{{6, 7, 8}}));
    osg::ref_ptr<osg::DrawArrayLengths> lengths = new osg::DrawArrayLengths(GL_TRIANGLE_FAN, 10);
    for (const int n : {4, 2, 3})
        lengths->push_back(n);
    EXPECT_EQ(trianglesOf(lengths), (List{{10, 11, 12}, {10, 12, 13}, {16, 17, 18}}));
    osg::ref_ptr<osg::MultiDrawArrays> several = new osg::MultiDrawArrays(GL_TRIANGLES);
    several->add(20, 3);
    several->add(5, 3);
    EXPECT_EQ(trianglesOf(several), (List{{20, 21, 22}, {5, 6, 7}}));
}

TEST(Triangles, AskingForBillionsEndsAfterTheFirstThatIsTooMany)
{
    EXPECT_EQ(trianglesOf(new osg::DrawArrays(GL_TRIANGLES, 0, 2000000000), 6).size(), 3u);
    EXPECT_LE(trianglesOf(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, -5), 6).size(), 8u);
    osg::ref_ptr<osg::DrawArrayLengths> lengths = new osg::DrawArrayLengths(GL_TRIANGLES, 0);
    lengths->push_back(-7);
    lengths->push_back(3);
    EXPECT_EQ(trianglesOf(lengths), (List{{0, 1, 2}}));
}

} // namespace
