// SPDX-License-Identifier: Apache-2.0
#include "GltfPrimitive.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <tiny_gltf.h>

#include <osgPMObjects/core/mesh/Wedge.h>

#include "GltfAccessor.h"

namespace osgPMObjects::core
{

namespace
{

bool isFinite(const glm::dvec4& v)
{
    const auto fits = [](double x) { return std::isfinite(static_cast<float>(x)); };
    return fits(v.x) && fits(v.y) && fits(v.z) && fits(v.w);
}

} // namespace

std::optional<std::vector<glm::dvec4>> GltfPrimitiveReader::attribute(const tinygltf::Primitive& primitive,
                                                                      const char* semantic)
{
    const auto found = primitive.attributes.find(semantic);
    if (found == primitive.attributes.end()) return {};
    auto values = accessorValues(_model, found->second);
    if (!values) fail("accessor " + std::to_string(found->second), "exceeds its buffer");
    return values;
}

foundation::Outcome GltfPrimitiveReader::read(const tinygltf::Primitive& primitive, std::uint32_t part,
                                              const glm::dmat4& matrix)
{
    readArrays(primitive, part, matrix);
    if (_error) return *_error;
    return foundation::success();
}

void GltfPrimitiveReader::readArrays(const tinygltf::Primitive& primitive, std::uint32_t part,
                                     const glm::dmat4& matrix)
{
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
        primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN && primitive.mode != -1)
    {
        ++_into.report.pointsAndLines;
        return;
    }
    if (const auto positions = primitive.attributes.find("POSITION");
        positions != primitive.attributes.end() && !hasData(_model, positions->second))
        return fail("accessor " + std::to_string(positions->second), "has no data");
    if (primitive.indices >= 0 && !hasData(_model, primitive.indices))
        return fail("accessor " + std::to_string(primitive.indices), "has no data");
    _positions = attribute(primitive, "POSITION").value_or(std::vector<glm::dvec4>{});
    _normals = attribute(primitive, "NORMAL");
    _texCoords[0] = attribute(primitive, "TEXCOORD_0");
    _texCoords[1] = attribute(primitive, "TEXCOORD_1");
    _colours = attribute(primitive, "COLOR_0");
    if (_error) return;
    _matrix = matrix;
    _normalMatrix = glm::transpose(glm::inverse(glm::dmat3(matrix)));
    _isMirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
    _wedges.assign(_positions.size(), HashIndex::kNone);
    _pattern = {{}, materialOf(primitive), part};
    countDropped(primitive);
    takeTriangles(primitive);
}

void GltfPrimitiveReader::countDropped(const tinygltf::Primitive& primitive)
{
    std::size_t known = primitive.attributes.count("POSITION");
    known +=
        (_normals ? 1u : 0u) + (_texCoords[0] ? 1u : 0u) + (_texCoords[1] ? 1u : 0u) + (_colours ? 1u : 0u);
    _into.report.droppedAttributes += primitive.attributes.size() - known;
    _into.report.animations += primitive.targets.size();
}

std::uint32_t GltfPrimitiveReader::materialOf(const tinygltf::Primitive& primitive)
{
    // The last material is the default one of the glTF specification, for primitives that name none.
    const std::size_t last = _into.materials.size() - 1;
    const std::size_t number = primitive.material >= 0 ? static_cast<std::size_t>(primitive.material) : last;
    const GltfMaterial& from = _into.materials[std::min(number, last)];
    Material material;
    material.name = from.name;
    material.state = static_cast<std::uint32_t>(std::min(number, last));
    material.isTwoSided = from.isTwoSided;
    material.litFromBothSides =
        from.isTwoSided; // section 3.9.4 (double sided): back faces are lit by reversed normals
    material.isTransparent = from.isBlended;
    material.attributes = (_normals ? Material::normal : 0u) | (_texCoords[0] ? Material::texCoord0 : 0u) |
                          (_texCoords[1] ? Material::texCoord1 : 0u) | (_colours ? Material::colour : 0u);
    material.unseen = Material::texCoord0 | Material::texCoord1;
    if (from.image >= 0)
        material.unseen &= ~(from.texCoordSet == 1 ? Material::texCoord1 : Material::texCoord0);
    const auto none = glm::dmat3x2(1.0);
    _texMatrices[0] = from.texCoordSet == 0 ? from.texMatrix : none;
    _texMatrices[1] = from.texCoordSet == 1 ? from.texMatrix : none;
    return _builder.material(material);
}

void GltfPrimitiveReader::takeTriangles(const tinygltf::Primitive& primitive)
{
    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0)
    {
        auto read = accessorIndices(_model, primitive.indices);
        if (!read) return fail("accessor " + std::to_string(primitive.indices), "has no valid indices");
        indices = std::move(*read);
    }
    else
        for (std::uint32_t i = 0; i < _positions.size(); ++i)
            indices.push_back(i);
    const std::size_t n = indices.size();
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP)
        for (std::size_t i = 0; i + 2 < n; ++i)
            take(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
    else if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN)
        for (std::size_t i = 1; i + 1 < n; ++i)
            take(indices[0], indices[i], indices[i + 1]);
    else
    {
        for (std::size_t i = 0; i + 2 < n; i += 3)
            take(indices[i], indices[i + 1], indices[i + 2]);
        if (n % 3 != 0) ++_into.report.refusedFaces; // its other corners are not there
    }
}

void GltfPrimitiveReader::take(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    if (_isMirrored) std::swap(b, c);
    Face face = _pattern;
    face.wedges = {wedgeOf(a), wedgeOf(b), wedgeOf(c)};
    for (const std::uint32_t wedge : face.wedges)
        if (wedge == HashIndex::kNone)
        {
            ++_into.report.refusedFaces;
            return;
        }
    _builder.face(face);
}

std::uint32_t GltfPrimitiveReader::wedgeOf(std::uint32_t vertex)
{
    if (vertex >= _wedges.size()) return HashIndex::kNone;
    if (_wedges[vertex] == HashIndex::kNone) _wedges[vertex] = makeWedge(vertex);
    return _wedges[vertex];
}

std::uint32_t GltfPrimitiveReader::makeWedge(std::uint32_t vertex)
{
    const glm::dvec4 p = _matrix * glm::dvec4(glm::dvec3(_positions[vertex]), 1.0);
    if (!isFinite(p)) return HashIndex::kNone;
    Wedge wedge;
    wedge.position = _builder.position(glm::dvec3(p));
    const auto finite = [&](const std::optional<std::vector<glm::dvec4>>& values) {
        return values && vertex < values->size() && isFinite((*values)[vertex]) ? &(*values)[vertex]
                                                                                : nullptr;
    };
    if (const glm::dvec4* n = finite(_normals))
    {
        const glm::dvec3 turned = _normalMatrix * glm::dvec3(*n);
        const double length = glm::length(turned);
        if (length > 0.0 && std::isfinite(length)) wedge.normal = glm::vec3(turned / length);
    }
    for (std::size_t set = 0; set < 2; ++set)
        if (const glm::dvec4* t = finite(_texCoords[set]))
            wedge.texCoords[set] = glm::vec2(_texMatrices[set] * glm::dvec3(t->x, t->y, 1.0));
    if (const glm::dvec4* c = finite(_colours)) wedge.colour = glm::vec4(*c);
    return _builder.wedge(wedge);
}

} // namespace osgPMObjects::core
