// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/order/TriangleOrders.h>

#include "OrderMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A shuffled grid of two materials and two parts.
Mesh shuffledGrid()
{
    const testsupport::IndexedMesh grid = testsupport::gridMesh(40, 30);
    testsupport::Random random(5);
    Mesh mesh;
    mesh.positions = grid.positions;
    for (std::uint32_t v = 0; v < grid.vertexCount(); ++v)
        mesh.wedgePositions.push_back(v);
    mesh.materials.resize(2);
    mesh.parts.resize(2);
    const auto count = static_cast<std::uint32_t>(grid.triangles.size());
    for (std::uint32_t i = 0; i < count; ++i)
    {
        const Triangle& t = grid.triangles[i];
        mesh.faces.push_back({{t[0], t[1], t[2]}, i < count / 3 ? 0u : 1u, i < count / 2 ? 0u : 1u});
    }
    for (std::size_t i = mesh.faces.size(); i > 1; --i)
        std::swap(mesh.faces[i - 1], mesh.faces[random.below(static_cast<std::uint32_t>(i))]);
    return mesh;
}

using Group = std::pair<std::uint32_t, std::uint32_t>;

Group groupOf(const Face& face)
{
    return {face.part, face.material};
}

/// Returns the vertices that a queue of 16 transforms, group by group.
std::size_t transforms(const Mesh& mesh)
{
    std::map<Group, std::vector<std::uint32_t>> drawn;
    for (const Face& face : mesh.faces)
        drawn[groupOf(face)].insert(drawn[groupOf(face)].end(), face.wedges.begin(), face.wedges.end());
    std::size_t count = 0;
    for (const auto& [group, indices] : drawn)
    {
        std::vector<std::uint32_t> queue;
        for (const std::uint32_t v : indices)
        {
            if (std::find(queue.begin(), queue.end(), v) != queue.end()) continue;
            ++count;
            queue.push_back(v);
            if (queue.size() > 16) queue.erase(queue.begin());
        }
    }
    return count;
}

TEST(FaceOrder, KeepsEachFaceAndWhatItBelongsTo)
{
    const Mesh before = shuffledGrid();
    const auto by = [](FaceOrder order) { return [order](Mesh& mesh) { orderFaces(mesh, order); }; };
    const std::vector<std::function<void(Mesh&)>> orders{by(FaceOrder::library), by(FaceOrder::universal),
                                                         by(FaceOrder::locality),
                                                         [](Mesh& mesh) { orderFaces(mesh, hilbertOrder); }};
    for (const auto& order : orders)
    {
        Mesh mesh = before;
        order(mesh);
        ASSERT_EQ(mesh.faces.size(), before.faces.size());
        const auto sorted = [](std::vector<Face> faces)
        {
            std::sort(faces.begin(), faces.end(),
                      [](const Face& a, const Face& b) { return a.wedges < b.wedges; });
            return faces;
        };
        EXPECT_EQ(sorted(mesh.faces), sorted(before.faces));
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            ASSERT_EQ(groupOf(mesh.faces[f]), groupOf(before.faces[f])) << f;
        EXPECT_LT(transforms(mesh), 0.5 * static_cast<double>(transforms(before)));
    }
    Mesh mesh = before;
    orderFaces(mesh, FaceOrder::asTheyAre);
    EXPECT_EQ(mesh.faces, before.faces);
}

} // namespace
