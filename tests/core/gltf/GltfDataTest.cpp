// SPDX-License-Identifier: Apache-2.0
// Where the values of a glTF stand: sparse accessors, compressed views, extensions by name.
#include <cmath>
#include <cstring>
#include <tuple>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <osgPMObjects/core/gltf/GltfImport.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace
{

using namespace osgPMObjects::core;
using Bytes = std::vector<unsigned char>;

std::string base64(const Bytes& bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const auto at = [&](std::size_t k) { return k < bytes.size() ? unsigned(bytes[k]) : 0u; };
        const unsigned three = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
    return text;
}

/// A glTF of one primitive, with the views of one buffer.
class ModelText
{
public:
    template<class Value>
    int view(const std::vector<Value>& values)
    {
        const std::size_t offset = _data.size(), length = values.size() * sizeof(Value);
        _data.resize((offset + length + 3) / 4 * 4);
        std::memcpy(_data.data() + offset, values.data(), length);
        _views += (_viewCount ? "," : "") + std::string(R"({"buffer":0,"byteOffset":)") +
                  std::to_string(offset) + R"(,"byteLength":)" + std::to_string(length) + "}";
        return _viewCount++;
    }

    /// Adds a view that stands elsewhere, in the text of JSON.
    int viewOf(const std::string& more)
    {
        _views += (_viewCount ? "," : "") + more;
        return _viewCount++;
    }

    int accessor(const std::string& more)
    {
        _accessors += (_accessorCount ? "," : "") + std::string("{") + more + "}";
        return _accessorCount++;
    }

    std::string attributes, primitive, members, material = R"("name":"paint")", buffers;

    std::string text() const
    {
        return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"material":0,"attributes":{)" +
               attributes + "}" + primitive + R"(}]}],"materials":[{)" + material + R"(}],"accessors":[)" +
               _accessors + R"(],"bufferViews":[)" + _views + R"(],"buffers":[{"byteLength":)" +
               std::to_string(_data.size()) + R"(,"uri":"data:application/octet-stream;base64,)" +
               base64(_data) + R"("})" + buffers + "]" + members + "}";
    }

    std::size_t size() const { return _data.size(); }

private:
    Bytes _data;
    std::string _views, _accessors;
    int _viewCount = 0, _accessorCount = 0;
};

foundation::Result<GltfModel> parsed(const std::string& text)
{
    return parseGltf({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, "test.gltf");
}

std::string sparseText(std::size_t count, int indices, int type, int values)
{
    return R"(,"sparse":{"count":)" + std::to_string(count) + R"(,"indices":{"bufferView":)" +
           std::to_string(indices) + R"(,"componentType":)" + std::to_string(type) +
           R"(},"values":{"bufferView":)" + std::to_string(values) + "}}";
}

constexpr const char* kTriangle = R"("componentType":5126,"type":"VEC3","count":3)";

/// Each type of index, with and without values below.
TEST(GltfData, SparsePositionsReplaceThoseBelow)
{
    const std::vector<float> corners{0, 0, 0, 2, 0, 0, 0, 2, 0};
    const auto diagonal = [&](bool hasBase, auto index, int type)
    {
        ModelText model;
        const int base = model.view(corners);
        const std::vector<decltype(index)> places{1, 2};
        const int indices = model.view(places), values = model.view(std::vector<float>{6, 0, 0, 0, 8, 0});
        const std::string view = hasBase ? R"("bufferView":)" + std::to_string(base) + "," : "";
        model.attributes =
            R"("POSITION":)" +
            std::to_string(model.accessor(view + kTriangle + sparseText(2, indices, type, values)));
        const auto read = parsed(model.text());
        EXPECT_TRUE(read) << (read ? "" : read.error().message());
        return read ? diagonalOf(read->mesh) : 0.0;
    };
    for (const bool hasBase : {true, false})
    {
        EXPECT_EQ(diagonal(hasBase, std::uint8_t{}, 5121), 10.0) << hasBase;
        EXPECT_EQ(diagonal(hasBase, std::uint16_t{}, 5123), 10.0) << hasBase;
        EXPECT_EQ(diagonal(hasBase, std::uint32_t{}, 5125), 10.0) << hasBase;
    }
}

TEST(GltfData, IndicesNormalsAndTextureCoordinatesMayBeSparseWithoutAView)
{
    ModelText model;
    const int corners = model.view(std::vector<float>{0, 0, 0, 3, 0, 0, 0, 4, 0});
    const int two = model.view(std::vector<std::uint16_t>{1, 2}),
              all = model.view(std::vector<std::uint16_t>{0, 1, 2});
    const int normals = model.view(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}),
              coords = model.view(std::vector<float>{0.5f, 0.0f, 0.0f, 0.25f});
    model.attributes =
        R"("POSITION":)" +
        std::to_string(model.accessor(R"("bufferView":)" + std::to_string(corners) + "," + kTriangle));
    model.attributes +=
        R"(,"NORMAL":)" + std::to_string(model.accessor(kTriangle + sparseText(3, all, 5123, normals)));
    model.attributes += R"(,"TEXCOORD_0":)" +
                        std::to_string(model.accessor(R"("componentType":5126,"type":"VEC2","count":3)" +
                                                      sparseText(2, two, 5123, coords)));
    model.primitive =
        R"(,"indices":)" + std::to_string(model.accessor(R"("componentType":5123,"type":"SCALAR","count":3)" +
                                                         sparseText(2, two, 5123, two)));
    const auto read = parsed(model.text());
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->mesh.faces.size(), 1u);
    EXPECT_EQ(diagonalOf(read->mesh), 5.0);
    const Face& face = read->mesh.faces[0];
    EXPECT_EQ(wedgeOf(read->mesh, face.wedges[0]).normal, glm::vec3(0, -1, 0));
    EXPECT_EQ(wedgeOf(read->mesh, face.wedges[1]).texCoords[0], glm::vec2(0.5f, 0.0f));
    EXPECT_EQ(wedgeOf(read->mesh, face.wedges[2]).texCoords[0], glm::vec2(0.0f, 0.25f));
}

TEST(GltfData, ASparseValueWithoutAPlaceIsRefused)
{
    for (const auto& [place, type, count] :
         {std::tuple{3u, 5125, 1u}, std::tuple{0u, 5126, 1u}, std::tuple{0u, 5125, 2u}})
    {
        ModelText model;
        const int indices = model.view(std::vector<std::uint32_t>{place}),
                  values = model.view(std::vector<float>{1, 1, 1});
        model.attributes =
            R"("POSITION":)" +
            std::to_string(model.accessor(kTriangle + sparseText(count, indices, type, values)));
        const auto read = parsed(model.text());
        ASSERT_FALSE(read) << place << ' ' << type << ' ' << count;
        EXPECT_EQ(read.error().what, "accessor 0 exceeds its buffer");
    }
}

/// No file of few bytes takes the memory of many zeros.
TEST(GltfData, ZerosWithoutEndAreRefused)
{
    ModelText model;
    const int indices = model.view(std::vector<std::uint32_t>{0}),
              values = model.view(std::vector<float>{1, 1, 1});
    model.attributes =
        R"("POSITION":)" +
        std::to_string(model.accessor(R"("componentType":5126,"type":"VEC3","count":4000000000)" +
                                      sparseText(1, indices, 5125, values)));
    EXPECT_FALSE(parsed(model.text()));
}

std::string triangleWith(const std::string& members)
{
    ModelText model;
    const int corners = model.view(std::vector<float>{0, 0, 0, 3, 0, 0, 0, 4, 0});
    model.attributes =
        R"("POSITION":)" +
        std::to_string(model.accessor(R"("bufferView":)" + std::to_string(corners) + "," + kTriangle));
    model.members = members;
    return model.text();
}

TEST(GltfData, AnUnknownExtensionThatIsRequiredIsNamed)
{
    for (const char* extension : {"KHR_draco_mesh_compression", "EXT_mesh_gpu_instancing",
                                  "KHR_texture_basisu", "VENDOR_unheard_of", "khr_mesh_quantization"})
    {
        const auto read = parsed(triangleWith(R"(,"extensionsUsed":[")" + std::string(extension) +
                                              R"("],"extensionsRequired":[")" + extension + R"("])"));
        ASSERT_FALSE(read) << extension;
        EXPECT_EQ(read.error().what,
                  "requires the extension " + std::string(extension) + ", which is not read");
    }
    for (const char* extension :
         {"KHR_mesh_quantization", "KHR_texture_transform", "EXT_meshopt_compression"})
    {
        const auto read = parsed(triangleWith(R"(,"extensionsUsed":[")" + std::string(extension) +
                                              R"("],"extensionsRequired":[")" + extension + R"("])"));
        ASSERT_TRUE(read) << read.error().message();
        EXPECT_TRUE(read->report.leftOutExtensions.empty());
    }
    const auto unlit = parsed(triangleWith(
        R"(,"extensionsUsed":["KHR_materials_unlit","EXT_other"],"extensionsRequired":["KHR_materials_unlit"])"));
    ASSERT_TRUE(unlit);
    EXPECT_EQ(unlit->report.leftOutExtensions,
              (std::vector<std::string>{"KHR_materials_unlit", "EXT_other"}));
}

TEST(GltfData, PositionsWithoutDataAreNoMeshOfZeros)
{
    ModelText model;
    model.view(std::vector<float>{0});
    model.attributes = R"("POSITION":)" + std::to_string(model.accessor(kTriangle));
    const auto bare = parsed(model.text());
    ASSERT_FALSE(bare);
    EXPECT_EQ(bare.error().what, "accessor 0 has no data");
    model.primitive = R"(,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0}})";
    const auto draco = parsed(model.text());
    ASSERT_FALSE(draco);
    EXPECT_EQ(draco.error().what,
              "has a mesh in the extension KHR_draco_mesh_compression, which is not read");
}

TEST(GltfData, OtherVersionsAreNamed)
{
    const auto versioned = [](const std::string& asset)
    {
        std::string text = triangleWith("");
        const std::string usual = R"("version":"2.0")";
        return parsed(text.replace(text.find(usual), usual.size(), asset));
    };
    EXPECT_TRUE(versioned(R"("version":"2.0","minVersion":"2.0")"));
    for (const auto& [asset, why] :
         {std::pair{R"("version":"1.0")", R"(is glTF of version "1.0", not 2)"},
          {R"("version":"3.0")", R"(is glTF of version "3.0", not 2)"},
          {R"("version":"2.1","minVersion":"2.1")", R"(requires a reader of glTF "2.1"; 2.0 is read)"}})
    {
        const auto read = versioned(asset);
        ASSERT_FALSE(read) << asset;
        EXPECT_EQ(read.error().what, why);
    }
}

/// assimp 6473, 6876: places near the end of a number, and values beyond a view that its buffer still holds.
TEST(GltfData, ValuesLieWithinTheirView)
{
    const auto model = [](const std::string& place)
    {
        ModelText text;
        const int corners = text.view(std::vector<float>{0, 0, 0, 2, 0, 0, 0, 2, 0});
        (void)text.view(std::vector<float>(12, 1.0f)); // of others
        text.attributes =
            "\"POSITION\":" + std::to_string(text.accessor("\"bufferView\":" + std::to_string(corners) + "," +
                                                           place + kTriangle));
        return parsed(text.text());
    };
    EXPECT_TRUE(model(""));
    EXPECT_TRUE(model("\"byteOffset\":0,"));
    for (const char* place : {"\"byteOffset\":4,", "\"byteOffset\":36,",
                              "\"byteOffset\":18446744073709551608,", "\"byteOffset\": -8,"})
    {
        const auto read = model(place);
        ASSERT_FALSE(read) << place;
        EXPECT_EQ(read.error().place, "test.gltf");
    }
    EXPECT_NE(model("\"byteOffset\" : -8,").error().message().find("has a byteOffset below 0"),
              std::string::npos);
}

/// assimp 6634: indices that are no whole triangles.
TEST(GltfData, ATriangleWithoutAllItsCornersIsTold)
{
    for (const auto& [count, faces, refused] :
         {std::tuple(6, 2u, 0u), std::tuple(5, 1u, 1u), std::tuple(4, 1u, 1u), std::tuple(1, 0u, 1u)})
    {
        ModelText text;
        const int corners = text.view(std::vector<float>{0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0});
        std::vector<std::uint16_t> indices{0, 1, 2, 2, 1, 3};
        indices.resize(static_cast<std::size_t>(count));
        const int view = text.view(indices);
        text.attributes = "\"POSITION\":" +
                          std::to_string(text.accessor("\"bufferView\":" + std::to_string(corners) +
                                                       R"(,"componentType":5126,"type":"VEC3","count":4)"));
        text.primitive = ",\"indices\":" +
                         std::to_string(text.accessor("\"bufferView\":" + std::to_string(view) +
                                                      R"(,"componentType":5123,"type":"SCALAR","count":)" +
                                                      std::to_string(count)));
        const auto read = parsed(text.text());
        ASSERT_TRUE(read) << read.error().message();
        EXPECT_EQ(read->mesh.faces.size(), faces) << count;
        EXPECT_EQ(read->report.refusedFaces, refused) << count;
    }
}

TEST(GltfData, ATextureTransformMovesTheCoordinates)
{
    ModelText model;
    const int corners = model.view(std::vector<float>{0, 0, 0, 3, 0, 0, 0, 4, 0}),
              coords = model.view(std::vector<float>{0, 0, 1, 0, 0, 1});
    model.attributes =
        R"("POSITION":)" +
        std::to_string(model.accessor(R"("bufferView":)" + std::to_string(corners) + "," + kTriangle)) +
        R"(,"TEXCOORD_0":)" +
        std::to_string(model.accessor(R"("bufferView":)" + std::to_string(coords) +
                                      R"(,"componentType":5126,"type":"VEC2","count":3)"));
    model.material =
        R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.5,0.25],"rotation":1.5707963267948966,"scale":[2,4]}}}})";
    const auto read = parsed(model.text());
    ASSERT_TRUE(read) << read.error().message();
    const Face& face = read->mesh.faces.at(0);
    const auto at = [&](int corner)
    { return wedgeOf(read->mesh, face.wedges[static_cast<std::size_t>(corner)]).texCoords[0]; };
    EXPECT_LT(glm::distance(at(0), glm::vec2(0.5f, 0.25f)), 1e-6f);
    EXPECT_LT(glm::distance(at(1), glm::vec2(0.5f, -1.75f)), 1e-6f)
        << "a quarter turn counter-clockwise, v downwards";
    EXPECT_LT(glm::distance(at(2), glm::vec2(4.5f, 0.25f)), 1e-6f);
}

std::string compressedView(const char* extension, std::size_t offset, const Bytes& data, std::size_t stride,
                           std::size_t count, const char* mode)
{
    return R"({"buffer":1,"byteLength":)" + std::to_string(stride * count) + R"(,"extensions":{")" +
           extension + R"(":{"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
           std::to_string(data.size()) + R"(,"byteStride":)" + std::to_string(stride) + R"(,"count":)" +
           std::to_string(count) + R"(,"mode":")" + mode + R"("}}})";
}

/// A fan of triangles about the first vertex, compressed; the text of its glTF. `damage`: the byte to change.
std::string compressedText(const char* extension, int damage = -1)
{
    std::vector<float> positions{0, 0, 1};
    std::vector<std::uint32_t> triangles;
    constexpr unsigned kCount = 40;
    for (unsigned i = 0; i < kCount; ++i)
    {
        positions.insert(positions.end(), {float(i), float(i * i % 7), 0.0f});
        if (i > 0) triangles.insert(triangles.end(), {0, i, i + 1});
    }
    Bytes vertices(meshopt_encodeVertexBufferBound(kCount + 1, 12)),
        indices(meshopt_encodeIndexBufferBound(triangles.size(), kCount + 1));
    meshopt_encodeVertexVersion(0);
    meshopt_encodeIndexVersion(1);
    vertices.resize(
        meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), positions.data(), kCount + 1, 12));
    indices.resize(
        meshopt_encodeIndexBuffer(indices.data(), indices.size(), triangles.data(), triangles.size()));
    if (damage >= 0) vertices[static_cast<std::size_t>(damage)] ^= 0xff;
    ModelText model;
    model.view(vertices);
    const std::size_t second = model.size();
    model.view(indices);
    const int points = model.viewOf(compressedView(extension, 0, vertices, 12, kCount + 1, "ATTRIBUTES")),
              faces =
                  model.viewOf(compressedView(extension, second, indices, 4, triangles.size(), "TRIANGLES"));
    model.attributes = R"("POSITION":)" +
                       std::to_string(model.accessor(R"("bufferView":)" + std::to_string(points) +
                                                     R"(,"componentType":5126,"type":"VEC3","count":41)"));
    model.primitive = R"(,"indices":)" +
                      std::to_string(model.accessor(R"("bufferView":)" + std::to_string(faces) +
                                                    R"(,"componentType":5125,"type":"SCALAR","count":117)"));
    model.buffers =
        R"(,{"byteLength":960,"extensions":{")" + std::string(extension) + R"(":{"fallback":true}}})";
    model.members = R"(,"extensionsRequired":[")" + std::string(extension) + R"("])";
    return model.text();
}

TEST(GltfData, ViewsThatMeshoptimizerCompressedAreRead)
{
    for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    {
        const auto read = parsed(compressedText(extension));
        ASSERT_TRUE(read) << read.error().message();
        EXPECT_EQ(read->mesh.faces.size(), 39u);
        EXPECT_EQ(read->mesh.positions.size(), 41u);
        EXPECT_DOUBLE_EQ(diagonalOf(read->mesh), std::sqrt(39.0 * 39.0 + 4.0 * 4.0 + 1.0));
    }
    const auto damaged = parsed(compressedText("EXT_meshopt_compression", 0));
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().what,
              "buffer view 2 is compressed by EXT_meshopt_compression and cannot be decompressed");
}

/// The same in a .glb, whose stand-in has no bytes of its own.
TEST(GltfData, ACompressedBinaryFileIsRead)
{
    std::string json = compressedText("EXT_meshopt_compression");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto number = [](std::size_t n)
    {
        const auto value = static_cast<std::uint32_t>(n);
        return std::string(reinterpret_cast<const char*>(&value), 4);
    };
    const std::string glb =
        "glTF" + number(2) + number(20 + json.size()) + number(json.size()) + "JSON" + json;
    const auto read = parseGlb({reinterpret_cast<const unsigned char*>(glb.data()), glb.size()}, "test.glb");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->mesh.faces.size(), 39u);
}

} // namespace
