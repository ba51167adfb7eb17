// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/gltf/GltfImport.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "GltfText.h"
#include "RealData.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::gltfText;

foundation::Result<GltfModel> parse(const std::string& text)
{
    return parseGltf({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, "test.gltf");
}

glm::dvec3 frontOf(const Mesh& mesh)
{
    const Face& f = mesh.faces.at(0);
    return glm::cross(mesh.at(f, 1) - mesh.at(f, 0), mesh.at(f, 2) - mesh.at(f, 0));
}

TEST(GltfImport, ReadsATriangleAndSetsItUpright)
{
    const auto model = parse(gltfText("", R"(,"material":0)"));
    ASSERT_TRUE(model) << model.error().message();
    ASSERT_EQ(model->mesh.faces.size(), 1u);
    EXPECT_EQ(model->mesh.positions[2], glm::dvec3(0, 0, 1)) << "y up has become z up";
    EXPECT_EQ(frontOf(model->mesh), glm::dvec3(0, -1, 0)) << "what faced the viewer's +z faces -y";
    EXPECT_EQ(model->mesh.parts.at(0).name, "tri");
    EXPECT_EQ(model->mesh.materials.at(0).name, "paint");
    EXPECT_TRUE(model->mesh.materials.at(0).isTwoSided);
}

TEST(GltfImport, AppliesTransformsAndKeepsMirroredFrontsInFront)
{
    const auto moved = parse(gltfText(R"(,"translation":[0,0,7],"scale":[2,2,2])"));
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->mesh.positions[1], glm::dvec3(2, -7, 0));
    const auto mirrored = parse(gltfText(R"(,"scale":[-1,1,1])"));
    ASSERT_TRUE(mirrored);
    EXPECT_EQ(frontOf(mirrored->mesh), glm::dvec3(0, -1, 0));
    const auto turned = parse(gltfText(R"(,"rotation":[0,1,0,0])")); // half a turn about y
    ASSERT_TRUE(turned);
    EXPECT_NEAR(frontOf(turned->mesh).y, 1.0, 1e-12);
}

TEST(GltfImport, RefusesWhatIsDamagedWithItsName)
{
    const std::string whole = gltfText();
    const auto replaced = [&](const std::string& what, const std::string& by)
    {
        std::string text = whole;
        const std::size_t place = text.find(what);
        EXPECT_NE(place, std::string::npos) << what;
        return text.replace(place, what.size(), by);
    };
    for (const std::string& text :
         {replaced("\"count\":3,\"type\":\"VEC3\"", "\"count\":4,\"type\":\"VEC3\""),
          replaced("\"byteOffset\":36", "\"byteOffset\":40"), replaced("5126", "5125000"),
          replaced("\"nodes\":[0]", "\"nodes\":[3]"), replaced("\"mesh\":0", "\"mesh\":4"),
          replaced("\"mesh\":0", "\"mesh\":0,\"children\":[0]"), replaced("\"POSITION\":0", "\"POSITION\":9"),
          replaced("\"bufferView\":0", "\"bufferView\":77"), replaced("\"buffer\":0", "\"buffer\":5"),
          whole.substr(0, whole.size() / 2), std::string("{}"), std::string()})
    {
        const auto model = parse(text);
        if (model)
            EXPECT_TRUE(model->mesh.faces.empty()) << text;
        else
            EXPECT_EQ(model.error().place, "test.gltf");
    }
    EXPECT_FALSE(parse(replaced("5123", "5126")));
}

TEST(GltfImport, CountsWhatItLeavesOut)
{
    EXPECT_EQ(parse(gltfText("", R"(,"mode":1)"))->report.pointsAndLines, 1u);
    std::string beyond = gltfText();
    beyond.replace(beyond.find("AAABAAIA"), 8, "AAABAAkA"); // index 9
    EXPECT_EQ(parse(beyond)->report.refusedFaces, 1u);
}

/// Other files are found only when the model is a file itself; a folder is no file.
TEST(GltfImport, ReadsOtherFilesButNoFolders)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "gltf-with-files";
    std::filesystem::create_directories(folder / "folder");
    const std::string whole = gltfText();
    const std::size_t first = whole.find("data:application"), last = whole.find('"', first);
    const auto naming = [&](const std::string& uri)
    { return whole.substr(0, first) + uri + whole.substr(last); };
    const auto write = [&](const char* name, const std::string& bytes)
    {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return folder / name;
    };
    write("buffer.bin", std::string(42, '\0'));
    const auto read = readGltf(write("beside.gltf", naming("buffer.bin")));
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->mesh.faces.size(), 1u);
    EXPECT_FALSE(readGltf(write("folder.gltf", naming("folder"))));
    EXPECT_FALSE(readGltf(folder));
    for (const std::string& uri : {std::string("."), std::string("/"), (folder / "buffer.bin").string()})
        EXPECT_FALSE(parse(naming(uri))) << "bytes have no folder: " << uri;
    std::filesystem::remove_all(folder);
}

TEST(GltfImport, ReadsTheRealEngine)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "models/cad/2CylinderEngine.glb");
    const auto model = readGltf(file);
    ASSERT_TRUE(model) << model.error().message();
    const MeshCounts counts = countMesh(model->mesh);
    EXPECT_EQ(counts.triangles, 121496u);
    EXPECT_EQ(counts.degenerates, 11160u);
    EXPECT_NEAR(static_cast<double>(counts.tJunctions), 6662.0, 100.0);
}

/// The parser accepts or refuses any bytes. The long run is the fuzzer's.
TEST(GltfImport, SurvivesMutations)
{
    std::mt19937 random(11);
    const std::string whole = gltfText(R"(,"scale":[1,2,1])", R"(,"material":0,"mode":5)");
    std::size_t read = 0;
    for (int i = 0; i < 3000; ++i)
    {
        std::string text = whole;
        for (unsigned n = 1 + random() % 4; n > 0; --n)
            text[random() % text.size()] =
                static_cast<char>(random() % 3 ? '0' + random() % 10 : random() % 256);
        if (const auto model = parse(text)) read += model->mesh.faces.size() <= 1;
    }
    EXPECT_GT(read, 100u) << "some are harmless";
}

} // namespace
