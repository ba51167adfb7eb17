// SPDX-License-Identifier: Apache-2.0
#include "GltfScene.h"

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <tiny_gltf.h>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

#include "GltfAccessor.h"

namespace osgPMObjects::core
{

namespace
{

constexpr int kDeepest = 256; ///< limit of node depth: a node that contains itself has no end

/// Rotation from y-up to z-up; columns are the images of the axes.
const glm::dmat4 kUpright(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);

glm::dmat4 matrixOf(const tinygltf::Node& node)
{
    glm::dmat4 matrix(1.0);
    if (node.matrix.size() == 16)
    {
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return matrix;
    }
    if (node.rotation.size() == 4)
        matrix = glm::mat4_cast(
            glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
    if (node.scale.size() == 3)
        for (int axis = 0; axis < 3; ++axis)
            matrix[axis] *= node.scale[static_cast<std::size_t>(axis)];
    if (node.translation.size() == 3)
        matrix[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
    return matrix;
}

bool isFinite(const glm::dvec4& v)
{
    const auto fits = [](double x) { return std::isfinite(static_cast<float>(x)); };
    return fits(v.x) && fits(v.y) && fits(v.z) && fits(v.w);
}

class SceneReader
{
public:
    SceneReader(const tinygltf::Model& model, const std::string& name, GltfModel& into)
        : _model(model), _name(name), _into(into)
    {
    }

    foundation::Outcome run()
    {
        for (const int root : roots())
            visit(root, kUpright, 0);
        if (_error) return *_error;
        _into.mesh = _builder.finish();
        return foundation::success();
    }

private:
    std::vector<int> roots() const
    {
        if (!_model.scenes.empty())
        {
            const std::size_t scene =
                _model.defaultScene >= 0 ? static_cast<std::size_t>(_model.defaultScene) : 0;
            return scene < _model.scenes.size() ? _model.scenes[scene].nodes : std::vector<int>{};
        }
        std::vector<bool> isChild(_model.nodes.size(), false);
        for (const tinygltf::Node& node : _model.nodes)
            for (const int child : node.children)
                if (child >= 0 && static_cast<std::size_t>(child) < isChild.size())
                    isChild[static_cast<std::size_t>(child)] = true;
        std::vector<int> all;
        for (std::size_t i = 0; i < isChild.size(); ++i)
            if (!isChild[i]) all.push_back(static_cast<int>(i));
        return all;
    }

    void fail(const std::string& place, const std::string& what)
    {
        if (!_error) _error = foundation::Error{_name, place + " " + what, "export the model again"};
    }

    void visit(int number, const glm::dmat4& above, int depth)
    {
        const std::string place = "node " + std::to_string(number);
        if (_error) return;
        if (number < 0 || static_cast<std::size_t>(number) >= _model.nodes.size())
            return fail(place, "does not exist");
        if (depth > kDeepest || ++_visits > 16 * _model.nodes.size() + 1024)
            return fail(place, "is nested too deep, or contains itself");
        const tinygltf::Node& node = _model.nodes[static_cast<std::size_t>(number)];
        const glm::dmat4 matrix = above * matrixOf(node);
        _into.report.animations += node.skin >= 0;
        if (node.mesh >= 0)
        {
            if (static_cast<std::size_t>(node.mesh) >= _model.meshes.size())
                return fail(place, "names a mesh that does not exist");
            readMesh(_model.meshes[static_cast<std::size_t>(node.mesh)], node.name, matrix);
        }
        for (const int child : node.children)
            visit(child, matrix, depth + 1);
    }

    void readMesh(const tinygltf::Mesh& mesh, const std::string& nodeName, const glm::dmat4& matrix)
    {
        const std::uint32_t part = _builder.part(mesh.name.empty() ? nodeName : mesh.name);
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            readPrimitive(primitive, part, matrix);
    }

    /// Returns the values of an attribute; empty where there is none, or where the file is damaged (_error is then set).
    std::optional<std::vector<glm::dvec4>> attribute(const tinygltf::Primitive& primitive,
                                                     const char* semantic)
    {
        const auto found = primitive.attributes.find(semantic);
        if (found == primitive.attributes.end()) return {};
        auto values = accessorValues(_model, found->second);
        if (!values) fail("accessor " + std::to_string(found->second), "is sparse, or exceeds its buffer");
        return values;
    }

    void readPrimitive(const tinygltf::Primitive& primitive, std::uint32_t part, const glm::dmat4& matrix)
    {
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
            primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN && primitive.mode != -1)
        {
            ++_into.report.pointsAndLines;
            return;
        }
        for (const char* compressed : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
            if (primitive.extensions.count(compressed))
                return fail("a primitive", std::string("needs ") + compressed);
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

    void countDropped(const tinygltf::Primitive& primitive)
    {
        std::size_t known = primitive.attributes.count("POSITION");
        known += (_normals ? 1u : 0u) + (_texCoords[0] ? 1u : 0u) + (_texCoords[1] ? 1u : 0u) +
                 (_colours ? 1u : 0u);
        _into.report.droppedAttributes += primitive.attributes.size() - known;
        _into.report.animations += primitive.targets.size();
    }

    std::uint32_t materialOf(const tinygltf::Primitive& primitive)
    {
        // The last material is the default one of the glTF specification, for primitives that name none.
        const std::size_t last = _into.materials.size() - 1;
        const std::size_t number =
            primitive.material >= 0 ? static_cast<std::size_t>(primitive.material) : last;
        const GltfMaterial& from = _into.materials[std::min(number, last)];
        Material material;
        material.name = from.name;
        material.state = static_cast<std::uint32_t>(std::min(number, last));
        material.isTwoSided = from.isTwoSided;
        material.litFromBothSides =
            from.isTwoSided; // section 3.9.4 (double sided): back faces are lit by reversed normals
        material.isTransparent = from.isBlended;
        material.attributes = (_normals ? Material::normal : 0u) |
                              (_texCoords[0] ? Material::texCoord0 : 0u) |
                              (_texCoords[1] ? Material::texCoord1 : 0u) | (_colours ? Material::colour : 0u);
        material.unseen = Material::texCoord0 | Material::texCoord1;
        if (from.image >= 0)
            material.unseen &= ~(from.texCoordSet == 1 ? Material::texCoord1 : Material::texCoord0);
        return _builder.material(material);
    }

    void takeTriangles(const tinygltf::Primitive& primitive)
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
            for (std::size_t i = 0; i + 2 < n; i += 3)
                take(indices[i], indices[i + 1], indices[i + 2]);
    }

    void take(std::uint32_t a, std::uint32_t b, std::uint32_t c)
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

    std::uint32_t wedgeOf(std::uint32_t vertex)
    {
        if (vertex >= _wedges.size()) return HashIndex::kNone;
        if (_wedges[vertex] == HashIndex::kNone) _wedges[vertex] = makeWedge(vertex);
        return _wedges[vertex];
    }

    std::uint32_t makeWedge(std::uint32_t vertex)
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
            if (const glm::dvec4* t = finite(_texCoords[set])) wedge.texCoords[set] = glm::vec2(t->x, t->y);
        if (const glm::dvec4* c = finite(_colours)) wedge.colour = glm::vec4(*c);
        return _builder.wedge(wedge);
    }

    const tinygltf::Model& _model;
    const std::string& _name;
    GltfModel& _into;
    MeshBuilder _builder;
    std::optional<foundation::Error> _error;
    std::size_t _visits = 0;

    // Of the current primitive.
    glm::dmat4 _matrix{1.0};
    glm::dmat3 _normalMatrix{1.0};
    bool _isMirrored = false;
    Face _pattern;
    std::vector<glm::dvec4> _positions;
    std::optional<std::vector<glm::dvec4>> _normals, _texCoords[2], _colours;
    std::vector<std::uint32_t> _wedges; ///< by vertex
};

} // namespace

foundation::Outcome readGltfScene(const tinygltf::Model& model, const std::string& name, GltfModel& into)
{
    return SceneReader(model, name, into).run();
}

} // namespace osgPMObjects::core
