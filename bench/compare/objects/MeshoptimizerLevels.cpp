// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <unordered_map>
#include <utility>

#include <meshoptimizer.h>

#include <osgPMObjects/core/mesh/Extent.h>

#include "compare/objects/SimplifyTool.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;

/// Of the model's size: no level is refused for it.
constexpr float kAnyError = 1e6f;

/// A mesh in the form that the library takes: one buffer of vertices for all draw calls. A wedge that several
/// materials use is as many vertices, so that a face's material can be told by its vertices, and the library
/// sees the border between them as a seam.
struct VertexBuffer
{
    std::vector<unsigned int> indices;
    std::vector<float> positions;            ///< three each, from the middle of the box
    std::vector<std::uint32_t> wedges;       ///< by vertex
    std::vector<std::uint32_t> faceOfVertex; ///< one that uses it: for its material and part
    std::size_t size() const { return wedges.size(); }
};

VertexBuffer bufferOf(const core::Mesh& mesh)
{
    VertexBuffer buffer;
    const core::Extent box = core::extentOf(mesh.positions);
    const glm::dvec3 middle = 0.5 * (box.low + box.high);
    std::unordered_map<std::uint64_t, std::uint32_t> vertices; // by wedge and material
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t wedge : mesh.faces[f].wedges)
        {
            const auto next = static_cast<std::uint32_t>(buffer.size());
            const std::uint64_t key = std::uint64_t(mesh.faces[f].material) << 32 | wedge;
            const auto [at, isNew] = vertices.try_emplace(key, next);
            buffer.indices.push_back(at->second);
            if (!isNew) continue;
            const glm::dvec3 p = mesh.positions[mesh.wedgePositions[wedge]] - middle;
            for (const double x : {p.x, p.y, p.z})
                buffer.positions.push_back(static_cast<float>(x));
            buffer.wedges.push_back(wedge);
            buffer.faceOfVertex.push_back(f);
        }
    return buffer;
}

core::Mesh levelOf(const core::Mesh& mesh, const VertexBuffer& buffer, std::span<const unsigned int> indices)
{
    core::Mesh level = mesh;
    level.faces.clear();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    {
        core::Face face = mesh.faces[buffer.faceOfVertex[indices[i]]];
        for (std::size_t corner = 0; corner < 3; ++corner)
            face.wedges[corner] = buffer.wedges[indices[i + corner]];
        level.faces.push_back(face);
    }
    return level;
}

} // namespace

foundation::Result<std::vector<SimplifiedLevel>> meshoptimizerLevels(const SimplifyTask& task)
{
    const core::Mesh& mesh = task.seams ? task.mesh : task.shape;
    const VertexBuffer buffer = bufferOf(mesh);
    std::vector<SimplifiedLevel> levels;
    for (const std::size_t target : task.targets)
    {
        std::vector<unsigned int> indices(buffer.indices.size());
        std::size_t count = 0;
        SimplifiedLevel& level = levels.emplace_back();
        level.ms = millisecondsOf(
            [&]
            {
                count = meshopt_simplify(indices.data(), buffer.indices.data(), buffer.indices.size(),
                                         buffer.positions.data(), buffer.size(), 3 * sizeof(float),
                                         3 * target, kAnyError);
            });
        level.mesh = levelOf(mesh, buffer, std::span(indices).first(count));
    }
    return levels;
}

} // namespace pmtool
