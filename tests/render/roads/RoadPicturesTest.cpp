// SPDX-License-Identifier: Apache-2.0
// The surface of a road in pictures: without gaps, with its marks, and calm far away.
#include <functional>

#include <gtest/gtest.h>

#include <osg/Geode>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include <osgRoads/RoadDrawable>
#include <osgRoads/RoadShader>

#include "RenderedPicture.h"
#include "RoadTexts.h"

namespace
{

using namespace osgRoads;
using namespace roadtexts;

/// A straight road of 200 m along x with a solid mark in its middle.
core::RoadMesh straightRoad()
{
    const std::string lanes =
        std::string(R"(<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false">)") +
        kWidth +
        R"(</lane></left><center><lane id="0" type="none" level="false"><roadMark sOffset="0" type="solid" width="0.15"/></lane></center>)" +
        R"(<right><lane id="-1" type="driving" level="false">)" + kWidth +
        "</lane></right></laneSection></lanes>";
    const auto read = std::make_shared<const core::RoadNetwork>(
        sound(network(road("1", 200.0, straightPlan(200.0) + lanes))));
    return core::buildRoadMesh(core::PlacedNetwork(read));
}

/// Shares of a picture: where nothing was drawn, and where paint is.
struct Shares
{
    double empty = 0.0, paint = 0.0;
};

Shares sharesOf(core::RoadMesh mesh, const osg::Vec3d& eye, const osg::Vec3d& at, const osg::Vec3d& up)
{
    const osg::ref_ptr<osg::Geode> scene = new osg::Geode;
    scene->addDrawable(new RoadDrawable(std::make_shared<const core::RoadMesh>(std::move(mesh))));
    scene->getOrCreateStateSet()->setAttributeAndModes(makeRoadProgram());
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = settings.heightPx = 96;
    const auto viewer = rendered::viewerOf(scene, settings);
    if (!viewer) return {};
    viewer->camera().setClearColor({1.0F, 0.0F, 1.0F, 1.0F});
    viewer->camera().setViewMatrixAsLookAt(eye, at, up);
    const osg::ref_ptr<osg::Image> picture = viewer->picture();
    Shares shares;
    const double one = 1.0 / (picture->s() * picture->t());
    for (int row = 0; row < picture->t(); ++row)
        for (int column = 0; column < picture->s(); ++column)
        {
            const osg::Vec4 colour = picture->getColor(column, row);
            if (colour.r() > 0.9F && colour.g() < 0.1F) shares.empty += one;
            if (colour.g() > 0.55F) shares.paint += one;
        }
    return shares;
}

/// Looks down on two lanes where two chunks meet; the middle mark runs through the picture.
Shares seenFromAbove(core::RoadMesh mesh)
{
    const double meet = mesh.chunks.front().sEnd;
    return sharesOf(std::move(mesh), {meet, 0.0, 6.0}, {meet, 0.0, 0.0}, {1.0, 0.0, 0.0});
}

TEST(RoadPictures, ChunksMeetWithoutAGap)
{
    ASSERT_GT(straightRoad().chunks.size(), 1u);
    EXPECT_EQ(seenFromAbove(straightRoad()).empty, 0.0);
}

TEST(RoadPictures, AMissingChunkIsSeen)
{
    core::RoadMesh mesh = straightRoad();
    mesh.chunks.erase(mesh.chunks.begin() + 1);
    EXPECT_GT(seenFromAbove(std::move(mesh)).empty, 0.3);
}

/// Buffers hold pages of consecutive chunks of about 32 768 vertices together; each is drawn from its own.
TEST(RoadPictures, PagesOfALongRoadMeetWithoutAGap)
{
    constexpr std::uint32_t kPageVertices = 1U << 15;
    const std::string plan =
        "<planView>" +
        geometry(R"(s="0" x="0" y="0" hdg="0")", 6000.0, R"(<spiral curvStart="0.02" curvEnd="-0.02"/>)") +
        "</planView>";
    const core::RoadMesh mesh = core::buildRoadMesh(placed(network(road("1", 6000.0, plan + twoLanes()))));
    std::uint32_t inPage = 0, pages = 1;
    for (std::size_t i = 0; i < mesh.chunks.size(); ++i)
    {
        if (inPage + mesh.chunks[i].vertexCount > kPageVertices)
        {
            const core::RoadChunk& chunk = mesh.chunks[i];
            const glm::dvec3 place = mesh.placeOf(mesh.vertices[chunk.firstVertex + chunk.vertexCount / 20]);
            const osg::Vec3d at(place.x, place.y, place.z);
            EXPECT_EQ(sharesOf(mesh, at + osg::Vec3d(0.0, 0.0, 4.0), at, {1.0, 0.0, 0.0}).empty, 0.0) << i;
            ++pages;
            inPage = 0;
        }
        inPage += mesh.chunks[i].vertexCount;
    }
    EXPECT_GT(pages, 1U);
}

TEST(RoadPictures, TheMarkIsAsWideAsTold)
{
    const double visibleM = 2.0 * 6.0 * std::tan(osg::DegreesToRadians(22.5)); // the viewer's 45 degrees
    EXPECT_NEAR(seenFromAbove(straightRoad()).paint, 0.15 / visibleM, 0.02);
}

TEST(RoadPictures, AMarkLeftOutIsSeen)
{
    core::RoadMesh mesh = straightRoad();
    for (core::MarkRow& row : mesh.marks)
        row = {};
    EXPECT_EQ(seenFromAbove(std::move(mesh)).paint, 0.0);
}

TEST(RoadPictures, BeyondTheFarthestDistanceNothingIsDrawn)
{
    const Shares shares = sharesOf(straightRoad(), {100.0, 0.0, 3000.0}, {100.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    EXPECT_NEAR(shares.empty, 1.0, 1e-9);
}

} // namespace
