// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/mat3x2.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// An image of 8-bit channels, top row first.
struct GltfImage
{
    int widthPx = 0, heightPx = 0;
    int channels = 0; ///< 1 to 4; 0: the image could not be read
    std::vector<unsigned char> bytes;
    std::string uri;  ///< of a file of its own; else empty
    std::string file; ///< the bytes of the image file, PNG or JPEG
};

/// A glTF material, as far as fixed function can show it.
struct GltfMaterial
{
    std::string name;
    glm::vec4 baseColour{1.0f};
    glm::vec3 emission{0.0f};
    double roughness = 1.0;
    int image = -1;              ///< index in GltfModel::images of the base colour; -1: none
    int texCoordSet = 0;         ///< texture coordinates of that image
    glm::dmat3x2 texMatrix{1.0}; ///< from the file's texture coordinates to those of the mesh, as (u, v, 1)
    bool isBlended = false;
    double alphaCutoff = -1.0; ///< fragments with less alpha are not drawn; negative: all are
    bool isTwoSided = false;
};

/// Counts of what was refused or left out.
struct GltfReport
{
    std::size_t refusedFaces = 0;   ///< an index beyond the vertices, or a coordinate that is not finite
    std::size_t pointsAndLines = 0; ///< primitives that are no surface: left out
    std::size_t unreadImages = 0;   ///< inside the file, of an unknown format or damaged
    std::vector<std::string> missingImages; ///< files of their own that cannot be read
    std::size_t droppedAttributes =
        0; ///< attribute arrays that Mesh cannot hold (tangents, joints, further sets)
    std::vector<std::string> leftOutExtensions; ///< used by the file, not required, and not read in whole
    std::size_t animations = 0; ///< with skins and morph targets: the mesh is in its rest pose
};

struct GltfModel
{
    Mesh mesh; ///< Material::state is an index in materials
    std::vector<GltfMaterial> materials;
    std::vector<GltfImage> images;
    GltfReport report;
};

/// Reads a .gltf or .glb file (version 2): the default scene with its transforms; triangles, strips and fans;
/// attributes of all component types, sparse ones, too; data compressed by meshoptimizer; texture transforms.
/// Frame: y-up glTF becomes z-up, (x, y, z) → (x, -z, y).
/// Errors: not readable, not glTF 2, damaged; an extension is required that is not read (Draco); nested too
/// deep; more vertices than 4 million and 4 for each byte of the buffers, since many nodes draw the same
/// data.
/// Source: Khronos, *glTF 2.0 specification* (2021), sections 3.6 (accessors) and 3.7 (primitives,
/// attributes).
foundation::Result<GltfModel> readGltf(const std::filesystem::path& file);

/// Reads a .glb from memory; files that it refers to are not opened. `name` appears in messages.
foundation::Result<GltfModel> parseGlb(std::span<const unsigned char> bytes, const std::string& name);

/// Reads the text of a .gltf from memory, in the same way.
foundation::Result<GltfModel> parseGltf(std::span<const unsigned char> bytes, const std::string& name);

} // namespace osgPMObjects::core
