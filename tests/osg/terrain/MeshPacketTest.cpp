// SPDX-License-Identifier: Apache-2.0
#include "view/MeshPacket.h"

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"
#include "view/ViewGroup.h"

namespace
{

using namespace osgTerrainROAM;

/// Plays the part of a context's buffers.
struct Buffers
{
    std::vector<core::MeshVertex> vertices;
    std::vector<core::LeafTriangle> triangles;
    std::uint64_t serial = 0;

    template<class Element>
    static void write(std::vector<Element>& to, const std::vector<core::IndexRange>& ranges,
                      const std::vector<Element>& from)
    {
        auto source = from.begin();
        for (const core::IndexRange& range : ranges)
        {
            std::copy(source, source + range.count, to.begin() + range.first);
            source += range.count;
        }
    }

    void take(const MeshPacket& packet)
    {
        ASSERT_TRUE(packet.whole || packet.serial == serial || packet.serial == serial + 1);
        vertices.resize(std::max<std::size_t>(vertices.size(), packet.vertexCount));
        triangles.resize(std::max<std::size_t>(triangles.size(), packet.triangleCount));
        if (packet.serial == serial) return;
        write(vertices, packet.vertexRanges, packet.vertices);
        write(triangles, packet.triangleRanges, packet.triangles);
        serial = packet.serial;
    }

    /// The vertices that a draw of some ranges reads, triangle by triangle.
    std::vector<core::MeshVertex> drawn(const core::TerrainMesh& mesh,
                                        const std::vector<core::IndexRange>& ranges) const
    {
        std::vector<core::MeshVertex> read;
        const auto draw = [&](std::size_t first, std::size_t count, std::size_t baseVertex)
        {
            for (std::size_t i = first; i < first + count; ++i)
            {
                const auto& corners = triangles[i].vertices;
                if (corners[0] == corners[1]) continue; // a gap
                for (const std::uint32_t slot : corners)
                    read.push_back(vertices[baseVertex + slot]);
            }
        };
        for (const core::IndexRange& range : ranges)
        {
            if (!mesh.patches())
                draw(range.first, range.count, 0);
            else
                for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
                    draw(0, triangles.size(), slot * mesh.patches()->shape().vertices.size());
        }
        return read;
    }

    /// Whether what is drawn are the triangles that the mesh draws.
    bool shows(const core::TerrainMesh& mesh, const std::vector<core::IndexRange>& ranges) const
    {
        const std::vector<core::MeshVertex> mine = drawn(mesh, ranges);
        const core::DrawnMesh wanted = mesh.drawn(ranges);
        if (mine.size() != 3 * wanted.triangles.size()) return false;
        for (std::size_t i = 0; i < mine.size(); ++i)
        {
            const core::MeshVertex& theirs = wanted.vertices[wanted.triangles[i / 3].vertices[i % 3]];
            if (mine[i] != theirs) return false;
        }
        return true;
    }
};

RefineTarget targetAt(double x, double y, double z)
{
    RefineTarget target;
    target.view.eyeWorld = {x, y, z};
    target.view.pixelsPerTangent = 700.0;
    target.view.nearM = 1.0;
    target.budget.errorTolerancePx = 2.0;
    return target;
}

/// Flies a path; context 0 takes every packet, context 1 only every fifth frame's.
void fly(ViewGroup& group, Buffers& steady, Buffers* seldom)
{
    testsupport::Random random(9);
    double x = 500, y = 500;
    for (unsigned int frame = 1; frame < 120; ++frame)
    {
        // Steps, and now and then a leap that makes the buffers grow and shrink.
        x = frame % 20 == 0 ? random.unit() * 3800 : x + 30 * random.unit();
        y = frame % 20 == 0 ? random.unit() * 3800 : y + 30 * random.unit();
        const RefineTarget target = targetAt(x, y, 500 + 1500 * random.unit());
        const ViewAnswer answer = group.answer(frame, target, viewlod::Frustum(), 0);
        steady.take(*answer.packet);
        group.visitMesh([&](const core::TerrainMesh& mesh)
                        { ASSERT_TRUE(steady.shows(mesh, answer.ranges)); });
        if (!seldom || frame % 5 != 0) continue;
        const ViewAnswer late = group.answer(frame, target, viewlod::Frustum(), 1);
        seldom->take(*late.packet);
        group.visitMesh([&](const core::TerrainMesh& mesh)
                        { ASSERT_TRUE(seldom->shows(mesh, late.ranges)); });
    }
}

} // namespace

class MeshPackets : public testing::TestWithParam<int>
{
};

TEST_P(MeshPackets, LeadEveryContextToTheMesh)
{
    ViewGroup group(std::make_unique<core::RoamMesh>(
        core::SplitBounds(testsupport::planarTile(testsupport::hills(129, 129)), GetParam())));
    Buffers steady, seldom;
    fly(group, steady, &seldom);
    EXPECT_GT(steady.serial, 50u);
}

INSTANTIATE_TEST_SUITE_P(Patches, MeshPackets, testing::Values(0, 2, 6));

TEST(MeshPacket, ALostPatchIsNoticed)
{
    core::RoamMesh mesh(core::SplitBounds(testsupport::planarTile(testsupport::hills(129, 129)), 4));
    mesh.refine(40.0);
    Buffers buffers;
    buffers.take(*wholePacket(mesh, 1));
    mesh.refine(20.0);
    MeshPacket packet = *changedPacket(mesh, 2);
    ASSERT_GT(packet.vertexRanges.size(), 0u);
    EXPECT_TRUE(packet.triangles.empty()) << "the patch's triangles never change";
    packet.vertices.resize(packet.vertices.size() - packet.vertexRanges.back().count);
    packet.vertexRanges.pop_back();
    buffers.take(packet);
    EXPECT_FALSE(buffers.shows(mesh, mesh.allRanges()));
}

TEST(MeshPacket, ALostRangeIsNoticed)
{
    // The mutation for the test above.
    core::RoamMesh mesh(testsupport::planarTile(testsupport::hills(129, 129)));
    mesh.refine(20.0);
    Buffers buffers;
    buffers.take(*wholePacket(mesh, 1));
    mesh.refine(5.0);
    MeshPacket packet = *changedPacket(mesh, 2);
    ASSERT_GT(packet.triangleRanges.size(), 0u);
    packet.triangles.resize(packet.triangles.size() - packet.triangleRanges.back().count);
    packet.triangleRanges.pop_back();
    buffers.take(packet);
    EXPECT_FALSE(buffers.shows(mesh, mesh.allRanges()));
    buffers.take(*wholePacket(mesh, 3));
    EXPECT_TRUE(buffers.shows(mesh, mesh.allRanges()));
}

TEST(MeshPacket, CarryFarLessThanTheMesh)
{
    ViewGroup group(std::make_unique<core::RoamMesh>(testsupport::planarTile(testsupport::hills(257, 257))));
    group.answer(1, targetAt(3000, 3000, 900), viewlod::Frustum(), 0);
    const auto answer = group.answer(2, targetAt(3003, 3000, 900), viewlod::Frustum(), 0);
    EXPECT_FALSE(answer.packet->whole);
    EXPECT_LT(answer.packet->triangles.size() * 4, answer.packet->triangleCount);
}

TEST(MeshPacket, TheSameEyeSendsNothingNew)
{
    ViewGroup group(std::make_unique<core::RoamMesh>(testsupport::planarTile(testsupport::hills(129, 129))));
    const auto first = group.answer(1, targetAt(3000, 3000, 900), viewlod::Frustum(), 0);
    const auto second = group.answer(2, targetAt(3000, 3000, 900), viewlod::Frustum(), 0);
    EXPECT_EQ(first.packet, second.packet);
}
