// SPDX-License-Identifier: Apache-2.0
// Round meshes for tests, with normals and texture coordinates.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

namespace testsupport
{

using osgPMObjects::core::Mesh;

/// A point of a surface over (u, v), each 0…1.
using SurfaceOf = std::function<glm::dvec3(double u, double v)>;

/// `columns` × `rows` rectangles of a surface that closes in u, two triangles each, with normals by
/// differences of its positions and (u, v) as texture coordinates. Triangles without area, at poles, are left
/// out.
inline Mesh roundMesh(std::uint32_t columns, std::uint32_t rows, const SurfaceOf& surface)
{
    osgPMObjects::core::MeshBuilder builder;
    using osgPMObjects::core::Material;
    builder.material({.name = "round", .attributes = Material::normal | Material::texCoord0});
    builder.part("round");
    const auto wedge = [&](std::uint32_t column, std::uint32_t row)
    {
        constexpr double kStep = 1e-5;
        const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
        const double inner =
            std::clamp(v, 10.0 * kStep, 1.0 - 10.0 * kStep); // at a pole there is no way along u
        const glm::dvec3 normal =
            glm::normalize(glm::cross(surface(u + kStep, inner) - surface(u - kStep, inner),
                                      surface(u, inner + kStep) - surface(u, inner - kStep)));
        const glm::dvec3 p = surface(column == columns ? 0.0 : u, v);
        return builder.wedge(
            {builder.position(p), glm::vec3(normal), {glm::vec2(u, v), glm::vec2(0.0f)}, {}});
    };
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        const auto& at = builder.mesh().wedgePositions;
        if (at[a] != at[b] && at[b] != at[c] && at[c] != at[a]) builder.face({{a, b, c}, 0, 0});
    };
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column)
        {
            const std::uint32_t a = wedge(column, row), b = wedge(column + 1, row);
            const std::uint32_t c = wedge(column + 1, row + 1), d = wedge(column, row + 1);
            face(a, b, c);
            face(a, c, d);
        }
    return builder.finish();
}

/// The unit sphere, poles on z; u goes east, v from the south pole to the north.
inline glm::dvec3 onSphere(double u, double v)
{
    const double east = 2.0 * std::numbers::pi * u, up = std::numbers::pi * (v - 0.5);
    // To the last bit at the poles, so that they are one position.
    const double out = v <= 0.0 || v >= 1.0 ? 0.0 : std::cos(up);
    return {out * std::cos(east), out * std::sin(east), v <= 0.0 ? -1.0 : v >= 1.0 ? 1.0 : std::sin(up)};
}

/// The sphere with bumps all over, up to 0.05 high.
inline glm::dvec3 onBumps(double u, double v)
{
    const glm::dvec3 p = onSphere(u, v);
    const double bump = std::sin(14.0 * p.x) * std::sin(14.0 * p.y) * std::sin(14.0 * p.z);
    return p * (1.0 + 0.05 * bump);
}

} // namespace testsupport
