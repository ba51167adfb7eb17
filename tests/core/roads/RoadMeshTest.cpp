// SPDX-License-Identifier: Apache-2.0
// The drawn surface against the exact one, by brute force.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "RealData.h"
#include "RoadTexts.h"
#include "ToldLines.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

/// Returns the greatest distance, in height, between a level and the exact surface on lanes, less its stated
/// error.
double worstExcess(const PlacedNetwork& network, const RoadMesh& mesh, const RoadChunk& chunk,
                   const ChunkLevel& level)
{
    double worst = -1e9;
    for (std::uint32_t i = level.firstIndex; i < level.firstIndex + level.indexCount; i += 3)
    {
        std::array<const MeshVertex*, 3> v{};
        for (std::uint32_t j = 0; j < 3; ++j)
            v[j] = &mesh.vertices[mesh.indices[i + j]];
        if (v[0]->kind == SurfaceKind::verge || v[0]->kind == SurfaceKind::skirt) continue;
        if (v[0]->width <= 0.1F && v[1]->width <= 0.1F) continue; // steps
        for (int a = 0; a <= 4; ++a)
            for (int b = 0; a + b <= 4; ++b)
            {
                const double wa = a / 4.0, wb = b / 4.0, wc = 1.0 - wa - wb;
                const glm::dvec3 at =
                    wa * mesh.placeOf(*v[0]) + wb * mesh.placeOf(*v[1]) + wc * mesh.placeOf(*v[2]);
                const auto matches = network.locator().within(glm::dvec2(at), 0.0);
                for (const RoadMatch& match : matches)
                {
                    if (match.position.road != chunk.road) continue;
                    const auto& [r, s, t, h] = match.position;
                    // Near a border the neighbour's height counts as well: the level may be off to a side,
                    // too, and a kerb of 12 cm leans by 5 mm where the road is banked by 0.04.
                    double gap = 1e9;
                    const double aside = 0.005 + level.errorM;
                    for (const double shift : {-aside, 0.0, aside})
                    {
                        const double from = std::clamp(s, chunk.sStart, std::nextafter(chunk.sEnd, 0.0));
                        gap = std::min(gap, std::fabs(network.surfacePoint(r, from, t + shift).z - at.z));
                    }
                    worst = std::max(worst, gap - level.errorM);
                }
            }
    }
    return worst;
}

TEST(RoadMesh, EveryLevelIsWithinItsStatedErrorOfTheSurface)
{
    const PlacedNetwork network = placed(bentRoad());
    const RoadMesh mesh = buildRoadMesh(network);
    ASSERT_FALSE(mesh.chunks.empty());
    std::size_t levels = 0;
    for (const RoadChunk& chunk : mesh.chunks)
        for (std::size_t i = 0; i < chunk.levels.size(); ++i, ++levels)
        {
            EXPECT_LT(worstExcess(network, mesh, chunk, chunk.levels[i]), 0.001)
                << "s " << chunk.sStart << " level " << i;
            if (i > 0)
            {
                EXPECT_GE(chunk.levels[i].errorM, chunk.levels[i - 1].errorM);
            }
        }
    EXPECT_GT(levels, mesh.chunks.size());
    EXPECT_LT(mesh.chunks.front().levels.front().errorM, 0.0045);
}

/// The check above must see a level that claims too much.
TEST(RoadMesh, AnUnderstatedErrorIsFound)
{
    const PlacedNetwork network = placed(bentRoad());
    const RoadMesh mesh = buildRoadMesh(network);
    double worst = -1e9;
    for (const RoadChunk& chunk : mesh.chunks)
    {
        ChunkLevel level = chunk.levels.back();
        level.errorM = 0.002;
        worst = std::max(worst, worstExcess(network, mesh, chunk, level));
    }
    EXPECT_GT(worst, 0.01);
}

/// A skirt of slope 2 with a normal of its own is drawn as a bare slope: a bright line along every road.
TEST(RoadMesh, SkirtsAreLitAsTheVergesBesideThem)
{
    const RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
    std::size_t skirts = 0;
    for (std::size_t i = 1; i < mesh.vertices.size(); ++i)
    {
        const MeshVertex &vertex = mesh.vertices[i], &before = mesh.vertices[i - 1];
        if (vertex.kind == before.kind) continue;
        if (vertex.kind != SurfaceKind::skirt && before.kind != SurfaceKind::skirt) continue;
        if (vertex.kind != SurfaceKind::verge && before.kind != SurfaceKind::verge)
            continue; // the next row's
        EXPECT_EQ(vertex.normal, before.normal) << i;
        ++skirts;
    }
    EXPECT_GT(skirts, 20u);
}

std::set<std::uint32_t> verticesAt(const RoadMesh& mesh, const RoadChunk& chunk, const ChunkLevel& level,
                                   double s)
{
    std::set<std::uint32_t> found;
    for (std::uint32_t i = level.firstIndex; i < level.firstIndex + level.indexCount; ++i)
        if (std::fabs(mesh.vertices[mesh.indices[i]].s - (s - chunk.sStart)) < 1e-4)
            found.insert(mesh.indices[i]);
    return found;
}

TEST(RoadMesh, EndsOfChunksAreTheSameAtEveryLevel)
{
    const RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
    for (std::size_t i = 0; i < mesh.chunks.size(); ++i)
    {
        const RoadChunk& chunk = mesh.chunks[i];
        for (const ChunkLevel& level : chunk.levels)
            for (const double s : {chunk.sStart, chunk.sEnd})
                EXPECT_EQ(verticesAt(mesh, chunk, level, s),
                          verticesAt(mesh, chunk, chunk.levels.front(), s));
        if (i + 1 == mesh.chunks.size() || mesh.chunks[i + 1].sStart == 70.0) continue;
        const RoadChunk& next = mesh.chunks[i + 1];
        std::set<std::array<std::int32_t, 3>> ends, starts;
        for (const auto v : verticesAt(mesh, chunk, chunk.levels.back(), chunk.sEnd))
            ends.insert(mesh.vertices[v].position);
        for (const auto v : verticesAt(mesh, next, next.levels.front(), next.sStart))
            starts.insert(mesh.vertices[v].position);
        EXPECT_EQ(ends, starts) << chunk.sEnd;
    }
}

TEST(RoadMesh, FarFromTheOriginItIsTheSameMesh)
{
    const RoadMesh near = buildRoadMesh(placed(bentRoad()));
    const RoadMesh far = buildRoadMesh(placed(bentRoad(R"(s="0" x="10000000" y="-10000000" hdg="0.3")")));
    ASSERT_EQ(near.vertices.size(), far.vertices.size());
    for (std::size_t i = 0; i < near.vertices.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_LE(std::abs(near.vertices[i].position[axis] - far.vertices[i].position[axis]), 1);
}

/// Positions are whole numbers of 32 bits: what lies farther from the middle of a network is left out.
TEST(RoadMesh, LeavesOutWhatLiesBeyondItsReach)
{
    const auto elevated = [](const std::string& height)
    {
        return buildRoadMesh(placed(network(
            road("1", 50.0,
                 straightPlan(50.0) + "<elevationProfile><elevation s=\"0\" a=\"0\" b=\"0\" c=\"0\" d=\"" +
                     height + "\"/></elevationProfile>" + twoLanes()))));
    };
    EXPECT_TRUE(elevated("1e12").chunks.empty());
    EXPECT_FALSE(elevated("15").chunks.empty()); // 1875 km high at its end
    EXPECT_TRUE(elevated("15").unreached.empty());
    EXPECT_EQ(elevated("1e12").unreached, std::vector<int>{0});
}

TEST(RoadMesh, RoadsBeyondItsReachAreTold)
{
    const auto twoRoads = [](const std::string& x)
    {
        const std::string far = "<planView>" +
                                geometry("s=\"0\" x=\"" + x + "\" y=\"0\" hdg=\"0\"", 50.0, "<line/>") +
                                "</planView>";
        const PlacedNetwork roads = placed(network(plainRoad("a") + road("b", 50.0, far + twoLanes())));
        return unreachedMessage(buildRoadMesh(roads), roads.network(), "two.xodr");
    };
    EXPECT_EQ(twoRoads("3900000"), "");
    EXPECT_EQ(twoRoads("4100000"), "two.xodr:3: road a and 1 more not drawn where they lie more than 2000 km "
                                   "from the middle of the network; "
                                   "split the network, or correct x, y and elevation");
}

/// Beside a tunnel there is hillside: the tube encloses the paved lanes. On a bridge an unpaved lane is part
/// of the deck.
TEST(RoadMesh, UnpavedLanesBesideATunnelAreNotThere)
{
    const auto farthestPresent = [](const std::string& structure)
    {
        const std::string none =
            std::string(R"(<lane id="2" type="none" level="false">)") + kWidth + "</lane><lane id=\"1\"";
        const std::string text =
            network(road("1", 50.0,
                         straightPlan(50.0) + replaced(twoLanes(), "<lane id=\"1\"", none) + "<objects><" +
                             structure + R"( id="x" s="0" length="50" type="standard"/></objects>)"));
        const RoadMesh mesh = buildRoadMesh(placed(text));
        double farthest = 0.0;
        for (const std::uint32_t index : mesh.indices)
            if (mesh.vertices[index].present > 0)
                farthest = std::max(farthest, mesh.placeOf(mesh.vertices[index]).y);
        return farthest;
    };
    EXPECT_NEAR(farthestPresent("tunnel"), 3.5, 1e-3);
    EXPECT_NEAR(farthestPresent("bridge"), 7.0, 1e-3);
}

/// No triangle is stored of which nothing is drawn.
TEST(RoadMesh, CoveredPiecesOfJunctionsHaveNoTriangles)
{
    const std::string crossing =
        road("2", 50.0,
             "<planView>" + geometry(R"(s="0" x="25" y="-25" hdg="1.5707963")", 50.0, "<line/>") +
                 "</planView>" + twoLanes(),
             "junction=\"9\"");
    const std::string text = network(road("1", 50.0, straightPlan(50.0) + twoLanes(), "junction=\"9\"") +
                                     crossing + "<junction id=\"9\" name=\"x\"/>");
    const RoadMesh mesh = buildRoadMesh(placed(text));
    std::size_t covered = 0;
    for (const MeshVertex& vertex : mesh.vertices)
        covered += vertex.present == 0 ? 1 : 0;
    EXPECT_GT(covered, 0u) << "else nothing is tested";
    for (std::size_t i = 0; i < mesh.indices.size(); i += 6)
    {
        int present = 0;
        for (std::size_t j = i; j < i + 6; ++j)
            present += mesh.vertices[mesh.indices[j]].present;
        EXPECT_GT(present, 0);
    }
}

TEST(RoadMesh, MarksOfBordersKeepTheirPhase)
{
    const RoadMesh mesh = buildRoadMesh(placed(bentRoad()));
    for (const MeshVertex& vertex : mesh.vertices)
        if (vertex.kind == SurfaceKind::asphalt && vertex.leftRow > 0)
        {
            EXPECT_LT(vertex.leftRow, mesh.marks.size());
        }
    std::set<float> phases;
    for (const MarkRow& row : mesh.marks)
        if (row[0].period > 0.0F) phases.insert(row[0].phase);
    EXPECT_GT(phases.size(), 1u); // 9 m do not divide the chunks
    EXPECT_FLOAT_EQ(mesh.marks[1][0].width + mesh.marks[2][0].width, 0.27F);
}

/// 100 roads of 40 m side by side; the middle mark of each is as wide as its number says, and each has an
/// arrow.
PlacedNetwork manyRoads()
{
    std::string roads;
    for (int i = 0; i < 100; ++i)
    {
        const std::string plan =
            "<planView>" +
            geometry("s=\"0\" x=\"0\" y=\"" + std::to_string(20 * i) + "\" hdg=\"0\"", 40.0, "<line/>") +
            "</planView>";
        const std::string mark =
            "<lane id=\"0\" type=\"none\" level=\"false\"><roadMark sOffset=\"0\" type=\"solid\" width=\"" +
            std::to_string(0.1 + 0.001 * i) + "\"/></lane>";
        roads += road(
            std::to_string(i), 40.0,
            plan + replaced(twoLanes(), "<lane id=\"0\" type=\"none\" level=\"false\"/>", mark) +
                R"(<signals><signal id="1" type="297" country="de" subtype="-1" dynamic="no" zOffset="0" s="20" t="-1.75" orientation="+"/></signals>)");
    }
    return placed(network(roads));
}

/// Returns what is wrong in a mesh of manyRoads(): vertices that are not their chunk's, or marks and decals
/// of another road.
std::string wrongIn(const RoadMesh& mesh)
{
    std::set<int> painted;
    for (const RoadChunk& chunk : mesh.chunks)
        for (std::uint32_t i = chunk.levels.front().firstIndex;
             i < chunk.levels.front().firstIndex + chunk.levels.front().indexCount; ++i)
        {
            if (mesh.indices[i] - chunk.firstVertex >= chunk.vertexCount) return "a vertex of another chunk";
            const MeshVertex& vertex = mesh.vertices[mesh.indices[i]];
            if (std::fabs(mesh.placeOf(vertex).y - 20.0 * chunk.road) > 10.0)
                return "a place of another road";
            for (const std::uint32_t row : {vertex.rightRow, vertex.leftRow})
                if (row > 0 && std::fabs(mesh.marks[row][0].width -
                                         (0.1F + 0.001F * static_cast<float>(chunk.road))) > 1e-5F)
                    return "a mark of another road";
            if (vertex.decalRow == 0) continue;
            const DecalRow &list = mesh.decals[vertex.decalRow], &first = mesh.decals[vertex.decalRow + 1];
            const double y = mesh.origin.y + 64.0 * list[1] + first[1];
            if (std::fabs(y - (20.0 * chunk.road - 1.75)) > 1e-3) return "a decal of another road";
            painted.insert(chunk.road);
        }
    return painted.size() == 100 ? "" : "a road without its arrow";
}

TEST(RoadMesh, PartsOfALargeNetworkAreJoinedWithTheirMarks)
{
    RoadMesh mesh = buildRoadMesh(manyRoads());
    ASSERT_EQ(mesh.chunks.size(), 100u);
    EXPECT_EQ(wrongIn(mesh), "");
    // Rows of the first part in a chunk of another.
    const RoadChunk& last = mesh.chunks.back();
    for (std::uint32_t i = 0; i < last.vertexCount; ++i)
        mesh.vertices[last.firstVertex + i].decalRow = mesh.vertices[mesh.chunks[3].firstVertex + i].decalRow;
    EXPECT_EQ(wrongIn(mesh), "a decal of another road");
}

TEST(RoadMesh, IsTheSameInEveryRun)
{
    const RoadMesh once = buildRoadMesh(manyRoads()), again = buildRoadMesh(manyRoads());
    EXPECT_EQ(once.indices, again.indices);
    EXPECT_EQ(once.decals, again.decals);
    ASSERT_EQ(once.vertices.size(), again.vertices.size());
    for (std::size_t i = 0; i < once.vertices.size(); ++i)
        EXPECT_EQ(once.vertices[i].position, again.vertices[i].position);
}

TEST(RoadMesh, LongNetworksAreSampledMoreCoarsely)
{
    RoadNetwork network;
    network.roads.resize(2);
    network.roads[0].length = 2e5;
    network.roads[0].isUsable = true;
    network.roads[1].length = 3e9; // told and left out
    network.roads[1].isUsable = false;
    EXPECT_EQ(meshSettingsFor(network).errorM, RoadMeshSettings().errorM);
    network.roads[0].length = 6e5;
    EXPECT_DOUBLE_EQ(meshSettingsFor(network).errorM, 2.0 * RoadMeshSettings().errorM);
    network.roads[0].length = 9e6;
    EXPECT_EQ(meshSettingsFor(network).errorM, 0.01);
}

/// All networks at hand; what they cost is printed.
TEST(RoadMesh, EveryFileAtHandIsMeshed)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "openscenario");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        if (entry.path().extension() != ".xodr") continue;
        auto read = readNetwork(entry.path());
        ASSERT_TRUE(read);
        const auto start = std::chrono::steady_clock::now();
        const PlacedNetwork network(std::make_shared<const RoadNetwork>(std::move(read->network)));
        const RoadMesh mesh = buildRoadMesh(network);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        EXPECT_FALSE(mesh.chunks.empty());
        double worst = 0.0;
        for (const RoadChunk& chunk : mesh.chunks)
        {
            ASSERT_FALSE(chunk.levels.empty());
            worst = std::max(worst, chunk.levels.front().errorM);
        }
        std::cout << entry.path().filename() << ": " << mesh.chunks.size() << " chunks, "
                  << mesh.vertices.size() << " vertices, " << mesh.marks.size()
                  << " mark rows, finest within " << worst << " m, " << seconds << " s\n";
    }
}

} // namespace
