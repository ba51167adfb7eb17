// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/bake/PackCharts.h>
#include <osgPMObjects/core/mesh/Mesh.h>

#include "FlatFaces.h"

namespace osgPMObjects::core
{

/// Which face each texel of an atlas shows: that around its centre, or beside a chart, as far as a picture that is looked at
/// between texels reaches, the nearest one.
struct TexelOwners
{
    static constexpr std::uint32_t kNone = ~0u;

    std::vector<std::uint32_t> faces; ///< by texel, row by row from below
    std::size_t covered = 0;          ///< texels with their centre in a face
};

TexelOwners texelOwners(const Mesh& mesh, const Atlas& atlas);

/// A face as it lies in the atlas. Units: texels.
FlatTriangle inAtlas(const Mesh& mesh, const Atlas& atlas, std::uint32_t face);

/// The weights of a triangle's corners at the point of it that is nearest to p; the triangle has an area.
glm::dvec3 weightsAt(const FlatTriangle& triangle, const glm::dvec2& p);

} // namespace osgPMObjects::core
