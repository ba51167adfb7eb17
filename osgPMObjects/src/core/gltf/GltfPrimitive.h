// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/mat3x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <osgPMObjects/core/gltf/GltfImport.h>
#include <osgPMObjects/core/mesh/MeshBuilder.h>

namespace tinygltf
{
class Model;
struct Primitive;
} // namespace tinygltf

namespace osgPMObjects::core
{

/// Reads primitives of a glTF model into a mesh: triangles, strips and fans. Others are counted in the
/// model's report.
/// Source: Khronos, *glTF 2.0 specification* (2021), section 3.7 (primitives, attributes).
class GltfPrimitiveReader
{
public:
    /// `name` appears in messages; `into` has its materials already.
    GltfPrimitiveReader(const tinygltf::Model& model, const std::string& name, MeshBuilder& builder,
                        GltfModel& into)
        : _model(model), _name(name), _builder(builder), _into(into)
    {
    }

    /// `matrix`: from the primitive's frame to the mesh's. Errors: damaged or compressed data.
    foundation::Outcome read(const tinygltf::Primitive& primitive, std::uint32_t part,
                             const glm::dmat4& matrix);

private:
    void fail(const std::string& place, const std::string& what)
    {
        if (!_error) _error = foundation::Error{_name, place + " " + what, "export the model again"};
    }
    void readArrays(const tinygltf::Primitive& primitive, std::uint32_t part, const glm::dmat4& matrix);
    /// Returns the values of an attribute; empty where there is none, or where the file is damaged (_error is
    /// then set).
    std::optional<std::vector<glm::dvec4>> attribute(const tinygltf::Primitive& primitive,
                                                     const char* semantic);
    void countDropped(const tinygltf::Primitive& primitive);
    std::uint32_t materialOf(const tinygltf::Primitive& primitive);
    void takeTriangles(const tinygltf::Primitive& primitive);
    void take(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    std::uint32_t wedgeOf(std::uint32_t vertex);
    std::uint32_t makeWedge(std::uint32_t vertex);

    const tinygltf::Model& _model;
    const std::string& _name;
    MeshBuilder& _builder;
    GltfModel& _into;
    std::optional<foundation::Error> _error;

    // Of the current primitive.
    glm::dmat4 _matrix{1.0};
    glm::dmat3 _normalMatrix{1.0};
    glm::dmat3x2 _texMatrices[2] = {glm::dmat3x2(1.0), glm::dmat3x2(1.0)}; ///< of the sets
    bool _isMirrored = false;
    Face _pattern;
    std::vector<glm::dvec4> _positions;
    std::optional<std::vector<glm::dvec4>> _normals, _texCoords[2], _colours;
    std::vector<std::uint32_t> _wedges; ///< by vertex
};

} // namespace osgPMObjects::core
