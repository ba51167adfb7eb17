// SPDX-License-Identifier: Apache-2.0
// The surface wears off where a road ends in the open, and nowhere else.
#include <algorithm>

#include <gtest/gtest.h>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

constexpr double kLengthM = 200.0, kWearM = 15.0;

/// A straight road eastwards from x on.
std::string straight(const std::string& id, double x, const std::string& link = "", double lengthM = kLengthM)
{
    return road(
        id, lengthM,
        link + "<planView>" +
            geometry("s=\"0\" x=\"" + std::to_string(x) + "\" y=\"0\" hdg=\"0\"", lengthM, "<line/>") +
            "</planView>" + twoLanes());
}

/// The greatest wear of the vertices from x to x, 0 to 127.
int wearBetween(const RoadMesh& mesh, double from, double to)
{
    int most = -1;
    for (const MeshVertex& vertex : mesh.vertices)
        if (const double x = mesh.placeOf(vertex).x; x >= from && x <= to)
            most = std::max<int>(most, vertex.normal[3]);
    return most;
}

RoadMesh meshOf(const std::string& roads)
{
    return buildRoadMesh(placed(network(roads)));
}

} // namespace

TEST(OpenEnds, WearOffWithinFifteenMetres)
{
    const RoadMesh mesh = meshOf(straight("1", 0.0));
    EXPECT_EQ(wearBetween(mesh, -0.1, 0.1), 127);
    EXPECT_EQ(wearBetween(mesh, kLengthM - 0.1, kLengthM + 0.1), 127);
    EXPECT_EQ(wearBetween(mesh, kWearM - 0.01, kLengthM - kWearM + 0.01), 0);
    const auto half = std::find_if(mesh.chunks.begin(), mesh.chunks.end(),
                                   [](const RoadChunk& chunk) { return chunk.sEnd == kWearM; });
    EXPECT_NE(half, mesh.chunks.end()) << "the wear is linear within a chunk, at every level";
}

TEST(OpenEnds, RoadsThatMeetAreWholeThere)
{
    for (const char* link :
         {"<link><successor elementType=\"road\" elementId=\"2\" contactPoint=\"start\"/></link>",
          ""}) // many files link nothing
    {
        const RoadMesh mesh = meshOf(straight("1", 0.0, link) + straight("2", kLengthM));
        EXPECT_EQ(wearBetween(mesh, 20.0, 2.0 * kLengthM - 20.0), 0) << link;
        EXPECT_EQ(wearBetween(mesh, 2.0 * kLengthM - 0.1, 2.0 * kLengthM + 0.1), 127) << link;
    }
    const RoadMesh apart = meshOf(straight("1", 0.0) + straight("2", kLengthM + 5.0));
    EXPECT_EQ(wearBetween(apart, kLengthM - 0.1, kLengthM + 0.1), 127) << "else the test could not fail";
}

TEST(OpenEnds, ShortRoadsAndBridgesKeepTheirEnds)
{
    EXPECT_EQ(wearBetween(meshOf(straight("1", 0.0, "", 40.0)), -1.0, 41.0), 0);
    const std::string bridge =
        "<objects><bridge id=\"b\" s=\"100\" length=\"92\" type=\"concrete\"/></objects>";
    std::string text = straight("1", 0.0);
    text.insert(text.find("</road>"), bridge);
    const RoadMesh mesh = meshOf(text);
    EXPECT_EQ(wearBetween(mesh, -0.1, 0.1), 127);
    EXPECT_EQ(wearBetween(mesh, kLengthM - 0.1, kLengthM + 0.1), 0);
}
