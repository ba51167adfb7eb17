// SPDX-License-Identifier: Apache-2.0
// Our triangles against those of an independent tessellator: SGI's sweep line, which OSG carries.
#include <cmath>
#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include <osg/GLU>

#include <osgPMObjects/core/tessellate/Tessellation.h>

#include "TestPolygons.h"

namespace
{

using testsupport::Polygon;
using testsupport::Random;

struct Peer
{
    std::deque<glm::dvec3> made; ///< positions of corners; addresses stay
    std::vector<glm::dvec3> triangles;
    bool failed = false;
};

void GL_APIENTRY takeCorner(void* corner, void* peer)
{
    static_cast<Peer*>(peer)->triangles.push_back(*static_cast<glm::dvec3*>(corner));
}

void GL_APIENTRY takeEdgeFlag(GLboolean, void*) {} // asks for triangles instead of fans and strips

void GL_APIENTRY takeError(GLenum, void* peer)
{
    static_cast<Peer*>(peer)->failed = true;
}

void GL_APIENTRY combine(GLdouble position[3], void* [4], GLfloat[4], void** made, void* peer)
{
    *made = &static_cast<Peer*>(peer)->made.emplace_back(position[0], position[1], position[2]);
}

template<class F>
osg::_GLUfuncptr callback(F* function)
{
    return reinterpret_cast<osg::_GLUfuncptr>(function);
}

Peer tessellateByPeer(const Polygon& polygon)
{
    Peer peer;
    osg::GLUtesselator* glu = osg::gluNewTess();
    osg::gluTessCallback(glu, GLU_TESS_VERTEX_DATA, callback(takeCorner));
    osg::gluTessCallback(glu, GLU_TESS_EDGE_FLAG_DATA, callback(takeEdgeFlag));
    osg::gluTessCallback(glu, GLU_TESS_ERROR_DATA, callback(takeError));
    osg::gluTessCallback(glu, GLU_TESS_COMBINE_DATA, callback(combine));
    osg::gluTessNormal(glu, 0, 0, 1);
    osg::gluTessBeginPolygon(glu, &peer);
    std::size_t corner = 0;
    for (const std::uint32_t size : polygon.contourSizes)
    {
        osg::gluTessBeginContour(glu);
        for (std::uint32_t i = 0; i < size; ++i, ++corner)
        {
            glm::dvec3& position = peer.made.emplace_back(polygon.corners[corner], 0.0);
            osg::gluTessVertex(glu, &position.x, &position);
        }
        osg::gluTessEndContour(glu);
    }
    osg::gluTessEndPolygon(glu);
    osg::gluDeleteTess(glu);
    return peer;
}

double areaOf(const std::vector<glm::dvec3>& corners)
{
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        area += 0.5 * std::abs(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]).z);
    return area;
}

std::vector<glm::dvec3> trianglesOf(const Polygon& polygon)
{
    const std::vector<glm::dvec3> corners = polygon.inSpace();
    const auto made = osgPMObjects::core::tessellate(corners, polygon.contourSizes);
    EXPECT_TRUE(made);
    std::vector<glm::dvec3> triangles;
    if (!made) return triangles;
    for (const osgPMObjects::core::Triangle& t : made->triangles)
        for (const std::uint32_t point : t)
            triangles.push_back(point < corners.size()
                                    ? corners[point]
                                    : positionOf(made->inserted[point - corners.size()], corners));
    return triangles;
}

bool covers(const std::vector<glm::dvec3>& corners, const glm::dvec2& position)
{
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    {
        int sides = 0;
        for (int k = 0; k < 3; ++k)
        {
            const glm::dvec2 a = corners[i + k], b = corners[i + (k + 1) % 3];
            sides += (b.x - a.x) * (position.y - a.y) - (b.y - a.y) * (position.x - a.x) > 0.0 ? 1 : -1;
        }
        if (sides == 3 || sides == -3) return true;
    }
    return false;
}

constexpr double kFloatTolerance = 1e-5; ///< the peer computes crossings in single precision

/// The results of comparing polygons.
struct Tally
{
    int inside = 0;    ///< of random positions
    int peerWrong = 0; ///< polygons whose area the peer has not, and we have, by the count of strips
};

/// The same area, and the same answer for random positions. Where areas differ, a third way decides.
void compare(const Polygon& polygon, double extent, Random& random, Tally& tally)
{
    const Peer peer = tessellateByPeer(polygon);
    EXPECT_FALSE(peer.failed);
    const std::vector<glm::dvec3> ours = trianglesOf(polygon);
    const double area = areaOf(ours);
    if (std::abs(area - areaOf(peer.triangles)) > kFloatTolerance)
    {
        EXPECT_NEAR(area, testsupport::oddArea(polygon), 1e-9);
        ++tally.peerWrong;
        return;
    }
    for (int i = 0; i < 10; ++i)
    {
        const glm::dvec2 position = extent * glm::dvec2(random.unit(), random.unit()) - extent / 4.0;
        EXPECT_EQ(covers(ours, position), covers(peer.triangles, position));
        tally.inside += covers(ours, position);
    }
}

TEST(GluTessellator, CoversTheSameOfTenThousandPolygonsWithHoles)
{
    Random random(11);
    Tally tally;
    for (int i = 0; i < 10000 && !testing::Test::HasFailure(); ++i)
        compare(testsupport::starWithHoles(random), 100.0, random, tally);
    EXPECT_GT(tally.inside, 20000);
    EXPECT_EQ(tally.peerWrong, 0);
}

TEST(GluTessellator, CoversTheSameOfTenThousandTangles)
{
    Random random(12);
    Tally tally;
    for (int i = 0; i < 10000 && !testing::Test::HasFailure(); ++i)
        compare(testsupport::tangle(random), 8.0, random, tally);
    EXPECT_GT(tally.inside, 5000);
    EXPECT_LT(tally.peerWrong, 200);
    RecordProperty("peerWrong", tally.peerWrong);
    RecordProperty("inside", tally.inside);
}

TEST(GluTessellator, DiffersWhereAHoleIsForgotten)
{
    Random random(13);
    Polygon polygon;
    do
        polygon = testsupport::starWithHoles(random);
    while (polygon.contourSizes.size() < 2);
    const double area = areaOf(tessellateByPeer(polygon).triangles);
    polygon.corners.resize(polygon.corners.size() - polygon.contourSizes.back());
    polygon.contourSizes.pop_back();
    EXPECT_GT(areaOf(trianglesOf(polygon)), area * (1.0 + 1e-6));
}

} // namespace
