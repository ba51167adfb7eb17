// SPDX-License-Identifier: Apache-2.0
// Meshes for tests of simplification.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <osgPMObjects/core/mesh/Wedge.h>

#include "MadeMeshes.h"
#include "OrderMeshes.h"

namespace testsupport
{

/// The same as a mesh of one material and one part, without attributes.
inline Mesh meshOf(const IndexedMesh& indexed)
{
    return meshOf(indexed.positions, indexed.triangles);
}

/// Both in one mesh, with their materials, the second moved.
inline Mesh together(Mesh a, const Mesh& b, const glm::dvec3& moved)
{
    using namespace osgPMObjects::core;
    const auto positions = static_cast<std::uint32_t>(a.positions.size());
    const auto wedges = static_cast<std::uint32_t>(a.wedgeCount());
    const auto materials = static_cast<std::uint32_t>(a.materials.size());
    for (const glm::dvec3& p : b.positions)
        a.positions.push_back(p + moved);
    for (std::uint32_t wedge = 0; wedge < b.wedgeCount(); ++wedge)
    {
        Wedge copy = wedgeOf(b, wedge);
        copy.position += positions;
        appendWedge(a, copy);
    }
    for (Face face : b.faces)
    {
        for (std::uint32_t& wedge : face.wedges)
            wedge += wedges;
        face.material += materials;
        a.faces.push_back(face);
    }
    a.materials.insert(a.materials.end(), b.materials.begin(), b.materials.end());
    return a;
}

/// The same with normals, at each wedge the mean of its faces' by their areas; up, where there is none.
inline Mesh lit(Mesh mesh)
{
    using namespace osgPMObjects::core;
    for (Material& material : mesh.materials)
        material.attributes |= Material::normal;
    mesh.normals.assign(mesh.wedgeCount(), glm::vec3(0.0f));
    for (const Face& face : mesh.faces)
    {
        const glm::vec3 normal(
            glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0)));
        for (const std::uint32_t wedge : face.wedges)
            mesh.normals[wedge] += normal;
    }
    for (glm::vec3& normal : mesh.normals)
        normal = glm::length(normal) > 0.0f ? glm::normalize(normal) : glm::vec3(0.0f, 0.0f, 1.0f);
    return mesh;
}

/// A grid in waves, so that no collapse is for nothing.
inline Mesh waves(std::uint32_t columns, std::uint32_t rows)
{
    Mesh mesh = grid(columns, rows);
    for (glm::dvec3& p : mesh.positions)
        p.z = 0.7 * std::sin(0.31 * p.x) * std::cos(0.23 * p.y) + 0.01 * std::sin(5.0 * p.x + 3.0 * p.y);
    return mesh;
}

/// Waves with a texture in two halves that meet along the middle column, where its coordinates jump; one
/// material.
inline Mesh texturedInHalves(std::uint32_t columns, std::uint32_t rows)
{
    using namespace osgPMObjects::core;
    const Mesh bare = waves(columns, rows);
    Mesh mesh;
    mesh.positions = bare.positions;
    mesh.materials = {{.name = "textured", .attributes = Material::texCoord0}};
    mesh.parts = bare.parts;
    std::array<std::vector<std::uint32_t>, 2> wedges; // by half and position
    for (std::uint32_t half = 0; half < 2; ++half)
        for (std::uint32_t p = 0; p < bare.positions.size(); ++p)
        {
            Wedge wedge{.position = p};
            const glm::dvec3& at = bare.positions[p];
            wedge.texCoords[0] = glm::vec2(at.x / columns + 0.4 * half, at.y / rows);
            wedges[half].push_back(appendWedge(mesh, wedge));
        }
    for (const Face& face : bare.faces)
    {
        double x = 0.0;
        for (int corner = 0; corner < 3; ++corner)
            x += bare.at(face, corner).x / 3.0;
        const int half = x < columns / 2 ? 0 : 1;
        Face copy = face;
        for (std::uint32_t& wedge : copy.wedges)
            wedge = wedges[half][wedge];
        mesh.faces.push_back(copy);
    }
    return mesh;
}

} // namespace testsupport
