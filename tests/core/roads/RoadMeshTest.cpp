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
#include <osgRoads/core/surface/RoadView.h>

#include "RealData.h"
#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

PlacedNetwork placed(const std::string& text)
{
    return PlacedNetwork(std::make_shared<const RoadNetwork>(sound(text)));
}

/// A bend that climbs and tilts, with a raised sidewalk and lanes that change in number and width.
std::string bentRoad(const std::string& start = R"(s="0" x="0" y="0" hdg="0.3")")
{
    const std::string right = std::string(R"(<right><lane id="-1" type="driving" level="false">)") + kWidth +
                              R"(<roadMark sOffset="0" type="broken" width="0.12"/></lane></right>)";
    const std::string centre =
        R"(<center><lane id="0" type="none" level="false"><roadMark sOffset="0" type="solid" width="0.15"/></lane></center>)";
    return network(road(
        "1", 150.0,
        "<planView>" + geometry(start, 150.0, R"(<spiral curvStart="0" curvEnd="0.03"/>)") + "</planView>" +
            R"(<elevationProfile><elevation s="0" a="5" b="0.06" c="-0.0005" d="0"/></elevationProfile>
<lateralProfile><superelevation s="0" a="0" b="0.0005" c="0" d="0"/></lateralProfile>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0.0002" d="0"/></lane>
<lane id="2" type="sidewalk" level="false"><width sOffset="0" a="2" b="0" c="0" d="0"/><height sOffset="0" inner="0.12" outer="0.15"/></lane></left>)" +
            centre + right +
            R"(</laneSection><laneSection s="70"><left><lane id="1" type="driving" level="false">)" + kWidth +
            "</lane></left>" + centre + right + "</laneSection></lanes>"));
}

/// Returns the greatest distance, in height, between a level and the exact surface on lanes, less its stated error.
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
                    // Near a border the neighbour's height counts as well: the level may be off to a side, too.
                    double gap = 1e9;
                    const double aside = 0.003 + level.errorM;
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

viewlod::ViewState viewFrom(const glm::dvec3& eye)
{
    glm::dmat4 view(1.0), projection(0.0);
    view[3] = glm::dvec4(-eye, 1.0); // looks down
    projection[0][0] = projection[1][1] = 1.0;
    projection[2][2] = -1.0;
    projection[2][3] = -1.0;
    projection[3][2] = -0.2;
    return viewlod::ViewState::fromMatrices(view, projection, 1000, 1000);
}

TEST(RoadView, DrawnHeightIsTheSurfaceNearTheEye)
{
    const PlacedNetwork network = placed(bentRoad());
    const RoadMesh mesh = buildRoadMesh(network);
    const RoadViewSettings settings;
    int asked = 0;
    for (double s = 5.0; s < 145.0; s += 7.0)
    {
        const glm::dvec3 on = network.surfacePoint(0, s, -1.5);
        const viewlod::ViewState view = viewFrom(on + glm::dvec3(0.0, 0.0, 10.0));
        const auto height =
            drawnHeight(mesh, chooseLevels(mesh, view, settings), view, settings, glm::dvec2(on));
        ASSERT_TRUE(height) << s;
        EXPECT_NEAR(*height, on.z, 0.01) << s;
        ++asked;
    }
    EXPECT_EQ(asked, 20);
    const viewlod::ViewState high =
        viewFrom(network.surfacePoint(0, 50.0, 0.0) + glm::dvec3(0.0, 0.0, 500.0));
    EXPECT_NEAR(liftAt(500.0, high, settings), 0.9, 1e-9); // 0.9 px at 500 px a unit of tangent
    EXPECT_EQ(liftAt(20.0, high, settings), 0.0);
}

TEST(RoadView, FarChunksAreCoarser)
{
    const PlacedNetwork network = placed(bentRoad());
    const RoadMesh mesh = buildRoadMesh(network);
    const auto triangles = [&](double heightM)
    {
        const viewlod::ViewState view =
            viewFrom(network.surfacePoint(0, 75.0, 0.0) + glm::dvec3(0.0, 0.0, heightM));
        std::size_t count = 0;
        for (const ChunkChoice& choice : chooseLevels(mesh, view, {}))
            count += mesh.chunks[choice.chunk].levels[choice.level].indexCount / 3;
        return count;
    };
    EXPECT_GT(triangles(150.0), 2 * triangles(2000.0));
    EXPECT_EQ(triangles(5000.0), 0u);
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
