// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// A picture of 8-bit channels, top row first.
struct GltfImage
{
    int widthPx = 0, heightPx = 0;
    int channels = 0; ///< 1 to 4; 0: the picture could not be read
    std::vector<unsigned char> bytes;
};

/// What a glTF material says, as far as fixed function can show it.
struct GltfMaterial
{
    std::string name;
    glm::vec4 baseColour{1.0f};
    glm::vec3 emission{0.0f};
    double roughness = 1.0;
    int image = -1;      ///< of the base colour, in GltfModel::images; -1: none
    int texCoordSet = 0; ///< that it is laid on with
    bool isBlended = false;
    double alphaCutoff = -1.0; ///< below, nothing is drawn; negative: no such test
    bool isTwoSided = false;
};

/// What was met besides faces.
struct GltfReport
{
    std::size_t refusedFaces = 0; ///< an index beyond the vertices, or a coordinate that is no finite number
    std::size_t pointsAndLines = 0; ///< primitives that are no surface: left out
    std::size_t unreadImages = 0;   ///< missing, or of a kind that is not read
    std::size_t droppedAttributes =
        0; ///< attribute arrays that a mesh has no place for (tangents, joints, further sets)
    std::size_t animations = 0; ///< and skins and morph targets: the mesh is as at rest
};

struct GltfModel
{
    Mesh mesh; ///< Material::state is an index in materials
    std::vector<GltfMaterial> materials;
    std::vector<GltfImage> images;
    GltfReport report;
};

/// Reads a .gltf or .glb file (version 2): the default scene with its transforms, triangles, strips and fans, attributes of all
/// component types. glTF has y up; the mesh has z up, (x, y, z) becomes (x, -z, y).
/// Errors: not readable, not glTF 2, damaged, compressed (Draco, meshopt) or sparse data; nested too deep.
/// Source: Khronos, "glTF 2.0 specification", §3.6 (accessors), §3.7 (primitives, attributes).
foundation::Result<GltfModel> readGltf(const std::filesystem::path& file);

/// The same from memory, for a .glb; files that it refers to are not looked for. `name` stands in messages.
foundation::Result<GltfModel> parseGlb(std::span<const unsigned char> bytes, const std::string& name);

/// The same from memory, for the text of a .gltf.
foundation::Result<GltfModel> parseGltf(std::span<const unsigned char> bytes, const std::string& name);

} // namespace osgPMObjects::core
