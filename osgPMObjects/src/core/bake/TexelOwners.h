// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/bake/PackCharts.h>
#include <osgPMObjects/core/mesh/Mesh.h>

#include "FlatFaces.h"

namespace osgPMObjects::core
{

/// The face that each texel of an atlas shows: the face at its centre; beside a chart, within the reach of
/// filtering, the nearest one.
struct TexelOwners
{
    static constexpr std::uint32_t kNone = ~0u;

    std::vector<std::uint32_t> faces; ///< by texel, row by row from the bottom
    std::size_t covered = 0;          ///< texels with their centre in a face
};

TexelOwners texelOwners(const Mesh& mesh, const Atlas& atlas);

/// Projects a face into the atlas. Units: texels.
FlatTriangle inAtlas(const Mesh& mesh, const Atlas& atlas, std::uint32_t face);

/// Returns the barycentric coordinates of the point of a triangle nearest to p; the triangle must have an
/// area.
glm::dvec3 weightsAt(const FlatTriangle& triangle, const glm::dvec2& p);

} // namespace osgPMObjects::core
