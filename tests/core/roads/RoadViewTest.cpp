// SPDX-License-Identifier: Apache-2.0
// What a view gets of a mesh: levels, heights, and the tree that spares it the rest.
#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgRoads/core/surface/ChunkTree.h>
#include <osgRoads/core/surface/RoadView.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

glm::dmat4 squareProjection()
{
    glm::dmat4 projection(0.0);
    projection[0][0] = projection[1][1] = 1.0;
    projection[2][2] = -1.0;
    projection[2][3] = -1.0;
    projection[3][2] = -0.2;
    return projection;
}

viewlod::ViewState viewFrom(const glm::dvec3& eye)
{
    glm::dmat4 view(1.0);
    view[3] = glm::dvec4(-eye, 1.0); // looks down
    return viewlod::ViewState::fromMatrices(view, squareProjection(), 1000, 1000);
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
    EXPECT_NEAR(liftAt(500.0, high, settings), 0.6, 1e-9); // 0.6 px at 500 px a unit of tangent
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

/// Chunks strewn over a country of 30 km, a hundred for each of its roads.
RoadMesh strewnChunks(std::mt19937& random)
{
    std::uniform_real_distribution<double> place(-15000.0, 15000.0), step(-50.0, 50.0), radius(2.0, 60.0);
    RoadMesh mesh;
    for (int road = 0; road < 60; ++road)
    {
        glm::dvec3 centre(place(random), place(random), 0.02 * place(random));
        for (int i = 0; i < 100; ++i)
        {
            RoadChunk chunk;
            chunk.road = road;
            chunk.centre = centre;
            chunk.radius = radius(random);
            chunk.levels = {{0, 3, 0.004}, {3, 3, 0.02}, {6, 3, 0.5}};
            mesh.chunks.push_back(chunk);
            centre += glm::dvec3(40.0 + step(random), step(random), 0.1 * step(random));
        }
    }
    return mesh;
}

/// A view from near a chunk into any direction.
viewlod::ViewState viewAmong(const RoadMesh& mesh, std::mt19937& random)
{
    std::uniform_real_distribution<double> turn(-3.1, 3.1), aside(-300.0, 300.0);
    std::uniform_int_distribution<std::size_t> which(0, mesh.chunks.size() - 1);
    const glm::dvec3 eye = mesh.chunks[which(random)].centre + glm::dvec3(aside(random), aside(random), 2.0);
    const double heading = turn(random);
    const glm::dvec3 ahead(std::cos(heading), std::sin(heading), -0.1);
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, eye + ahead, {0.0, 0.0, 1.0}),
                                            squareProjection(), 1000, 1000);
}

/// Returns how many of so many views get other choices by the tree than by a look at every chunk.
int viewsThatDiffer(const RoadMesh& mesh, const ChunkTree& tree, int views, std::size_t& choices)
{
    std::mt19937 random(3);
    int differing = 0;
    for (int i = 0; i < views; ++i)
    {
        const viewlod::ViewState view = viewAmong(mesh, random);
        const auto found = chooseLevels(mesh, tree, view, {}), wanted = chooseLevels(mesh, view, {});
        differing += found == wanted ? 0 : 1;
        choices += wanted.size();
    }
    return differing;
}

TEST(ChunkTree, ChoosesWhatALookAtEveryChunkChooses)
{
    std::mt19937 random(8);
    const RoadMesh mesh = strewnChunks(random);
    std::size_t choices = 0;
    EXPECT_EQ(viewsThatDiffer(mesh, ChunkTree(mesh), 300, choices), 0);
    EXPECT_GT(choices, 3000u);
}

/// The check above must see a branch that is too small.
TEST(ChunkTree, AChunkLargerThanTheTreeKnowsIsMissed)
{
    std::mt19937 random(8);
    RoadMesh mesh = strewnChunks(random);
    const ChunkTree tree(mesh);
    for (RoadChunk& chunk : mesh.chunks)
        chunk.radius *= 1.2;
    std::size_t choices = 0;
    EXPECT_GT(viewsThatDiffer(mesh, tree, 300, choices), 50);
}

TEST(ChunkTree, AViewPaysForWhatItSees)
{
    std::mt19937 random(8);
    const RoadMesh mesh = strewnChunks(random);
    const ChunkTree tree(mesh);
    EXPECT_EQ(tree.visible(viewFrom({100000.0, 0.0, 100.0}), 2500.0).looks, 1u);
    std::size_t looks = 0, seen = 0;
    for (int i = 0; i < 100; ++i)
    {
        const auto visible = tree.visible(viewAmong(mesh, random), 2500.0);
        looks += visible.looks;
        seen += visible.chunks.size();
    }
    EXPECT_LT(looks, 5 * seen + 100 * 100); // of 600 000 that a look at every chunk takes
    EXPECT_EQ(ChunkTree(RoadMesh()).visible(viewFrom({0.0, 0.0, 1.0}), 2500.0).looks, 0u);
}

} // namespace
