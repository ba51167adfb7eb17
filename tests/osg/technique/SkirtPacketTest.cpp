// SPDX-License-Identifier: Apache-2.0
#include "view/SkirtPacket.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM;

struct Skirt
{
    Skirt(int columns, int rows, double errorM, double depth)
        : tile(testsupport::planarTile(testsupport::hills(columns, rows))),
          mesh(core::SplitBounds(tile, 0)),
          depthM(depth)
    {
        mesh.refine(errorM);
        packet = skirtPacket(mesh, 7, [depth](const glm::dvec3&) { return depth; });
    }

    std::shared_ptr<const core::RoamTile> tile;
    core::RoamMesh mesh;
    double depthM;
    PacketPtr packet;

    /// Samples of the border that walls stand on, each counted once: 2 · (columns - 1 + rows - 1) when none
    /// is missing.
    double coveredSamples() const
    {
        const int lastColumn = tile->tile.grid().dataColumns() - 1,
                  lastRow = tile->tile.grid().dataRows() - 1;
        double covered = 0.0;
        for (std::size_t wall = 0; wall + 3 < packet->vertices.size(); wall += 4)
        {
            const auto at = [&](std::size_t i) { return glm::dvec2(packet->vertices[wall + i].grid); };
            const glm::dvec2 last(lastColumn, lastRow);
            const glm::dvec2 along = glm::abs(glm::min(at(1), last) - glm::min(at(0), last));
            covered += std::max(along.x, along.y);
        }
        return covered;
    }

    bool hangsStraightDown() const
    {
        const double stepM = tile->tile.frame().vertexStepM();
        for (std::size_t wall = 0; wall + 3 < packet->vertices.size(); wall += 4)
            for (const std::size_t top : {wall, wall + 1})
            {
                const glm::dvec3 fall = core::positionOf(packet->vertices[top], stepM) -
                                        core::positionOf(packet->vertices[top + 2], stepM);
                if (glm::length(fall - glm::dvec3(0.0, 0.0, depthM)) > 2.0 * stepM) return false;
            }
        return true;
    }
};

} // namespace

TEST(SkirtPacket, HangsFromEveryEdgeOfTheBorder)
{
    for (const double errorM : {0.0, 5.0, 60.0})
    {
        const Skirt skirt(65, 65, errorM, 12.0);
        EXPECT_EQ(skirt.coveredSamples(), 4.0 * 64) << errorM;
        EXPECT_TRUE(skirt.hangsStraightDown());
        EXPECT_EQ(skirt.packet->serial, 7u);
        EXPECT_TRUE(skirt.packet->whole);
    }
}

TEST(SkirtPacket, HangsFromWhereTrianglesCrossTheDatasEdge)
{
    for (const double errorM : {0.0, 5.0, 60.0})
    {
        const Skirt skirt(50, 41, errorM, 3.0);
        // Places between samples are told to the nearest one: each wall may be half a sample off at either
        // end.
        EXPECT_NEAR(skirt.coveredSamples(), 2.0 * (49 + 40), 4.0) << errorM;
        EXPECT_TRUE(skirt.hangsStraightDown());
    }
}

TEST(SkirtPacket, HasNoMoreWallsThanTheBorderHasEdges)
{
    const Skirt fine(65, 65, 0.0, 1.0), coarse(65, 65, 1000.0, 1.0);
    EXPECT_LE(fine.packet->triangleCount, 2u * 4 * 64);
    EXPECT_EQ(coarse.packet->triangleCount, 2u * 4) << "two triangles are the tile";
}

TEST(SkirtPacket, FollowsTheEarthsNormal)
{
    const auto tile = std::make_shared<const core::RoamTile>(
        core::PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65)), core::Placement::curved));
    core::RoamMesh mesh(core::SplitBounds(tile, 0));
    mesh.refine(1.0);
    const PacketPtr packet = skirtPacket(mesh, 1, [](const glm::dvec3&) { return 100.0; });
    const double stepM = tile->tile.frame().vertexStepM();
    const glm::dvec3 fall =
        core::positionOf(packet->vertices[0], stepM) - core::positionOf(packet->vertices[2], stepM);
    EXPECT_NEAR(glm::length(fall), 100.0, 2.0 * stepM);
    EXPECT_GT(std::hypot(fall.x, fall.y), 0.01) << "not along the tile's own z";
}

TEST(SkirtPacket, PatchesHaveNone)
{
    const auto tile = testsupport::planarTile(testsupport::hills(65, 65));
    core::RoamMesh mesh(core::SplitBounds(tile, 4));
    mesh.refine(5.0);
    EXPECT_FALSE(skirtPacket(mesh, 1, [](const glm::dvec3&) { return 1.0; }));
}
