// SPDX-License-Identifier: Apache-2.0
// Crowns of leaf cards, and how much of the sky a mesh covers.
#pragma once

#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>
#include <osgPMObjects/core/mesh/Wedge.h>

#include "Random.h"
#include "SimplifyMeshes.h"

namespace testsupport
{

enum class LeafKind
{
    triangle,
    quad,
    doubled ///< a quad that has a back of its own
};

/// Leaves in a ball of radius 1, each showing the whole of a texture (a triangle: the half of it).
inline Mesh crown(LeafKind kind, int leaves, double size)
{
    using namespace osgPMObjects::core;
    Random random(5);
    const auto direction = [&]
    {
        for (;;)
        {
            glm::dvec3 d;
            for (int axis = 0; axis < 3; ++axis)
                d[axis] = 2.0 * random.unit() - 1.0;
            if (glm::dot(d, d) < 1.0 && glm::dot(d, d) > 1e-3) return d;
        }
    };
    Mesh mesh = meshOf({}, {});
    for (int leaf = 0; leaf < leaves; ++leaf)
    {
        const glm::dvec3 at = direction();
        const glm::dvec3 right = size * glm::normalize(direction());
        const glm::dvec3 up = size * glm::normalize(glm::cross(right, direction()));
        const glm::vec3 normal(glm::normalize(glm::cross(right, up)));
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner : {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        {
            const auto position = static_cast<std::uint32_t>(mesh.positions.size());
            if (kind == LeafKind::triangle && position == first + 3) break;
            mesh.positions.push_back(at + double(corner.x) * right + double(corner.y) * up);
            appendWedge(mesh, {position, normal, {corner}, {}});
        }
        mesh.faces.push_back({{first, first + 1, first + 2}, 0, 0});
        if (kind != LeafKind::triangle) mesh.faces.push_back({{first, first + 2, first + 3}, 0, 0});
        if (kind != LeafKind::doubled) continue;
        mesh.faces.push_back({{first, first + 3, first + 1}, 0, 0});
        mesh.faces.push_back({{first + 1, first + 3, first + 2}, 0, 0});
    }
    return mesh;
}

/// How many of 3 × 48² rays through a box, along its axes, meet a mesh.
inline int cover(const Mesh& mesh, const osgPMObjects::core::Extent& box)
{
    constexpr int kRays = 48;
    const auto triangles = osgPMObjects::core::properTriangles(mesh);
    const osgPMObjects::core::TriangleTree tree(mesh.positions, triangles);
    const glm::dvec3 size = box.high - box.low;
    int met = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < kRays; ++i)
            for (int j = 0; j < kRays; ++j)
            {
                glm::dvec3 from = box.low, along(0.0);
                from[(axis + 1) % 3] += size[(axis + 1) % 3] * (i + 0.5) / kRays;
                from[(axis + 2) % 3] += size[(axis + 2) % 3] * (j + 0.5) / kRays;
                from[axis] -= 0.01 * size[axis];
                along[axis] = 2.0 * size[axis];
                met += tree.isHit(from, along, 0.0);
            }
    return met;
}

} // namespace testsupport
