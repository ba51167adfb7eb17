// SPDX-License-Identifier: Apache-2.0
// Verges where there is no room for them: between the lanes of a junction, and inside a tight bend.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

std::string rightLane()
{
    return std::string(
               R"(<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">)") +
           kWidth + "</lane></right></laneSection></lanes>\n";
}

/// Two roads of 40 m along x, `apartM` from each other; the lane of each is on its right.
RoadMesh twoRoads(double apartM, const std::string& attributes)
{
    const std::string other =
        "<planView>" +
        geometry("s=\"0\" hdg=\"0\" x=\"0\" y=\"" + std::to_string(-apartM) + "\"", 40.0, "<line/>") +
        "</planView>";
    const auto read =
        parseNetwork(network(road("1", 40.0, straightPlan(40.0) + rightLane(), attributes) +
                             road("2", 40.0, other + rightLane(), attributes) + "<junction id=\"9\"/>"),
                     "test.xodr");
    EXPECT_TRUE(read);
    return read ? buildRoadMesh(PlacedNetwork(std::make_shared<const RoadNetwork>(read->network)))
                : RoadMesh{};
}

/// How many strips of each kind a row of the mesh has.
std::map<SurfaceKind, std::size_t> kindsOf(const RoadMesh& mesh)
{
    std::map<SurfaceKind, std::size_t> kinds;
    for (const MeshVertex& vertex : mesh.vertices)
        ++kinds[vertex.kind];
    const std::size_t skirts = std::max<std::size_t>(kinds[SurfaceKind::skirt], 1);
    for (auto& [kind, count] : kinds)
        count = 4 * count / skirts; // two roads have four skirts
    return kinds;
}

TEST(JunctionSurface, NoGrassStaysBetweenTheLanesOfAJunction)
{
    // 8 m apart: 4.5 m between the lane of the first and that of the second, which both have a verge there.
    const auto inJunction = kindsOf(twoRoads(8.0, "junction=\"9\""));
    EXPECT_EQ(inJunction.at(SurfaceKind::asphalt), 4U); // two lanes, two verges
    EXPECT_EQ(inJunction.at(SurfaceKind::verge), 2U);
    // Beside each other without a junction, or far apart in one, they keep all four.
    EXPECT_EQ(kindsOf(twoRoads(8.0, "junction=\"-1\"")).at(SurfaceKind::verge), 4U);
    EXPECT_EQ(kindsOf(twoRoads(16.0, "junction=\"9\"")).at(SurfaceKind::verge), 4U);
}

TEST(JunctionSurface, AVergeDoesNotFoldOverTheCentreOfABend)
{
    // A left bend of 5 m: lane, verge and skirt on its inner side would reach 6.75 m.
    const std::string plan = "<planView>" +
                             geometry(R"(s="0" x="0" y="0" hdg="0")", 7.0, R"(<arc curvature="0.2"/>)") +
                             "</planView>";
    const RoadMesh mesh = buildRoadMesh(PlacedNetwork(
        std::make_shared<const RoadNetwork>(sound(network(road("1", 7.0, plan + twoLanes()))))));
    ASSERT_FALSE(mesh.vertices.empty());
    for (const MeshVertex& vertex : mesh.vertices)
    {
        EXPECT_GE(vertex.normal[2], 0); // upside down behind the centre
        EXPECT_LT(mesh.placeOf(vertex).y, 5.0);
    }
}

} // namespace
