// SPDX-License-Identifier: Apache-2.0
#include "GltfScene.h"

#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <tiny_gltf.h>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

#include "GltfPrimitive.h"

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

/// Returns the limit of wedges and faces: data may be drawn several times, but not without end.
std::size_t mostElementsOf(const tinygltf::Model& model)
{
    constexpr std::size_t kFew = 1 << 22, kOfByte = 4;
    std::size_t most = kFew;
    for (const tinygltf::Buffer& buffer : model.buffers)
        most += kOfByte * buffer.data.size();
    return most;
}

/// Walks the nodes of a scene and reads their meshes.
class SceneReader
{
public:
    SceneReader(const tinygltf::Model& model, const std::string& name, GltfModel& into)
        : _model(model),
          _name(name),
          _into(into),
          _primitives(model, name, _builder, into),
          _mostElements(mostElementsOf(model))
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
        {
            if (_error) return;
            const foundation::Outcome read = _primitives.read(primitive, part, matrix);
            if (!read) _error = read.error();
            if (_builder.mesh().wedgeCount() + _builder.mesh().faces.size() > _mostElements)
                return fail("the scene", "draws the same data too often");
        }
    }

    const tinygltf::Model& _model;
    const std::string& _name;
    GltfModel& _into;
    MeshBuilder _builder;
    GltfPrimitiveReader _primitives;
    std::optional<foundation::Error> _error;
    std::size_t _visits = 0;
    const std::size_t _mostElements; ///< wedges and faces
};

} // namespace

foundation::Outcome readGltfScene(const tinygltf::Model& model, const std::string& name, GltfModel& into)
{
    return SceneReader(model, name, into).run();
}

} // namespace osgPMObjects::core
