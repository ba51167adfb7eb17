// SPDX-License-Identifier: Apache-2.0
// Smoothing groups of Wavefront .obj files, as they reach meshes and progressive meshes.
#include "read/ObjSmoothing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/ReadModel>

#include "TestFolder.h"

namespace
{

using namespace osgPMObjects;

/// A strip of four quads, bent at x = 1, 2 and 3; the second and the third have other materials.
constexpr const char* kBent = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nv 2 1 1\nv 3 0 1\nv 3 1 1\n"
                              "v 4 0 0\nv 4 1 0\n";

/// The strip with statements before each of its faces.
std::string bentText(const std::string& a, const std::string& b, const std::string& c, const std::string& d)
{
    return kBent + a + "f 1 2 3 4\n" + b + "f 2 5 6 3\n" + c + "f 5 7 8 6\n" + d + "f 7 9 10 8\n";
}

core::Mesh readText(const std::string& text)
{
    const testsupport::TestFolder folder("obj_smoothing");
    const auto node = readModelNodeHere(folder.write("a.obj", text));
    EXPECT_TRUE(node) << node.error().message();
    auto model = importNode(**node, "a.obj");
    EXPECT_TRUE(model) << model.error().message();
    return std::move(model->mesh);
}

/// The number of different normals at the bend with this x, over all materials.
std::size_t normalsAt(const core::Mesh& mesh, double x)
{
    std::set<std::tuple<int, int, int>> normals;
    for (const core::Face& face : mesh.faces)
        for (int c = 0; c < 3; ++c)
            if (std::abs(mesh.at(face, c).x - x) < 1e-6)
            {
                const glm::vec3 n = 1000.0f * mesh.normals[face.wedges[static_cast<std::size_t>(c)]];
                normals.insert({int(std::lround(n.x)), int(std::lround(n.y)), int(std::lround(n.z))});
            }
    return normals.size();
}

TEST(ObjSmoothing, FacesOfDifferentGroupsShareNoNormal)
{
    const core::Mesh one = readText(bentText("s 1\n", "", "", "")),
                     two = readText(bentText("s 1\n", "", "s 2\n", ""));
    EXPECT_EQ(normalsAt(one, 1), 1u);
    EXPECT_EQ(normalsAt(one, 2), 1u);
    EXPECT_EQ(normalsAt(two, 1), 1u);
    EXPECT_EQ(normalsAt(two, 2), 2u);
    EXPECT_EQ(normalsAt(two, 3), 1u);
}

TEST(ObjSmoothing, AGroupGoesOnAcrossMaterialsAndObjects)
{
    EXPECT_EQ(normalsAt(readText(bentText("s 7\n", "usemtl b\n", "o c\n", "g d\n")), 1), 1u);
    const core::Mesh mesh = readText(bentText("s 7\n", "usemtl b\n", "o c\n", "g d\ns 8\n"));
    EXPECT_EQ(normalsAt(mesh, 2), 1u);
    EXPECT_EQ(normalsAt(mesh, 3), 2u);
}

TEST(ObjSmoothing, FacesOfNoGroupAreFlat)
{
    for (const char* none : {"s off\n", "s 0\n"})
    {
        const core::Mesh mesh = readText(bentText("s 3\n", "", none, ""));
        EXPECT_EQ(normalsAt(mesh, 1), 1u) << none;
        EXPECT_EQ(normalsAt(mesh, 2), 2u) << none;
        EXPECT_EQ(normalsAt(mesh, 3), 2u) << none;
    }
    const core::Mesh before = readText(bentText("", "", "s 1\n", "")); // before the first statement
    EXPECT_EQ(normalsAt(before, 1), 2u);
    EXPECT_EQ(normalsAt(before, 3), 1u);
}

TEST(ObjSmoothing, ReachesProgressiveMeshes)
{
    const testsupport::TestFolder folder("obj_smoothing");
    const auto bends = [&](const std::string& text)
    {
        const auto node = readModelNodeHere(folder.write("a.obj", text));
        EXPECT_TRUE(node);
        const auto model = makeProgressive(**node, "a.obj", {.ladder = std::nullopt});
        EXPECT_TRUE(model);
        const auto level = importNode(*bakeLevel(*model->node->shape(), 0), "level");
        EXPECT_TRUE(level);
        EXPECT_EQ(level->mesh.faces.size(), 8u);
        return std::array{normalsAt(level->mesh, 1), normalsAt(level->mesh, 2), normalsAt(level->mesh, 3)};
    };
    EXPECT_EQ(bends(bentText("s 1\n", "", "s 2\n", "s off\n")), (std::array<std::size_t, 3>{1, 2, 2}));
    EXPECT_EQ(bends(bentText("s 1\n", "", "", "")), (std::array<std::size_t, 3>{1, 1, 1}));
}

TEST(ObjSmoothing, HasAsManyGroupsAsThereAre)
{
    std::string text = "v 0 0 0\nv 0 1 0\n";
    for (int i = 1; i <= 100; ++i)
    {
        const std::string x = std::to_string(i), z = std::to_string(0.3 * i * i / 10.0);
        text += "v " + x + " 0 " + z + "\nv " + x + " 1 " + z + "\n";
        text += "s " + std::to_string(1000 + i / 2) + "\nf -4 -2 -1 -3\n"; // two faces a group
    }
    const core::Mesh mesh = readText(text);
    for (int i = 1; i < 100; ++i)
        EXPECT_EQ(normalsAt(mesh, i), i % 2 ? 2u : 1u) << i;
}

TEST(ObjSmoothing, KeepsTexturesMaterialsAndGivenNormals)
{
    const testsupport::TestFolder folder("obj_smoothing");
    folder.write("b.mtl", "newmtl b\nKd 1 0 0\nmap_Kd nowhere.png\n");
    const std::string text = "mtllib b.mtl\n" + std::string(kBent) +
                             "vt 0 0\nvt .5 0\nvt .5 1\nvt 0 1\nusemtl b\ns 1\n"
                             "f 1/1 2/2 \\\n 3/3 4/4\nf 2/1 5/2 6/3 3/-1\n";
    const auto node = readModelNodeHere(folder.write("a.obj", text));
    ASSERT_TRUE(node);
    EXPECT_EQ((*node)->getDescriptions(), std::vector<std::string>{missingImageNote("nowhere.png")});
    const auto model = importNode(**node, "a.obj");
    ASSERT_TRUE(model);
    ASSERT_EQ(model->mesh.faces.size(), 4u);
    for (const core::Face& face : model->mesh.faces)
        EXPECT_TRUE(model->mesh.materials[face.material].has(core::Material::texCoord0));
    EXPECT_EQ(normalsAt(model->mesh, 1), 1u);
    const core::Mesh given = readText("vn 0 1 0\nvn 0 0 1\n" + std::string(kBent) +
                                      "s 1\nf 1//1 2//1 3//1 4//1\nf 2//2 5//2 6//2\n");
    EXPECT_EQ(normalsAt(given, 1), 2u);
}

TEST(ObjSmoothing, AConcaveFaceHasOneFront)
{
    // An L, cut as a fan from its first corner, would have a triangle upside down.
    const std::string text = "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\ns 1\nf 2 3 4 5 6 1\n";
    const core::Mesh mesh = readText(text);
    for (const core::Face& face : mesh.faces)
        for (const std::uint32_t wedge : face.wedges)
            EXPECT_LT(glm::distance(mesh.normals[wedge], glm::vec3(0, -1, 0)), 1e-6f);
    EXPECT_EQ(mesh.faces.size(), 4u);
}

TEST(ObjSmoothing, LeavesAloneWhatIsNotToBeSmoothed)
{
    EXPECT_FALSE(withGroupNormals(bentText("", "", "", "")));                // names no group
    EXPECT_FALSE(withGroupNormals(bentText("s 1\n", "vn 0 0 1\n", "", ""))); // has normals
    EXPECT_FALSE(withGroupNormals(bentText("s 1\n", "f 1//1 2//1 3//1\n", "", "")));
    for (const char* wrong : {"v 1 x 2\n", "v 1 2\n", "v 1 2 3 4\n", "v nan 0 0\n", "s x\n", "f 1 2 99\n",
                              "f 1 2 0\n", "f 1 2 -99\n", "f 1 2 y\n"})
        EXPECT_FALSE(withGroupNormals(bentText("s 1\n", "", wrong, ""))) << wrong;
    const auto changed = withGroupNormals(bentText("s 1\n", "# f 1 2 99\n", "l 1 2\n", ""));
    ASSERT_TRUE(changed);
    EXPECT_NE(changed->find("\nl 1 2\n"), changed->npos);
    EXPECT_NE(changed->find("# f 1 2 99\n"), changed->npos);
    // Faces without area, and those whose edges cross, get some normal.
    const auto odd = withGroupNormals("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ns 1\nf 1 1 2\nf 1 2 3 4\n");
    ASSERT_TRUE(odd);
    EXPECT_EQ(std::count(odd->begin(), odd->end(), 'n') >= 1, true);
    EXPECT_EQ(odd->find("nan"), odd->npos);
}

} // namespace
