// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgRoads/core/query/BoxTree.h>
#include <osgRoads/core/surface/Decal.h>
#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// A four-sided piece of the drawn surface; corners in order. Frame: the scene's.
using SurfaceQuad = std::array<glm::dvec3, 4>;

/// Finds what is painted on pieces of the surface and writes it into lists for the shader. A decal belongs to every surface that it
/// lies on, whichever road that is of: a crosswalk at the end of a road reaches into the junction.
class DecalRows
{
public:
    /// `origin`: of the mesh.
    DecalRows(const PlacedNetwork& network, const glm::dvec3& origin);

    /// Returns the row of the list of what lies on any of the quads; 0: nothing.
    std::uint32_t listFor(std::span<const SurfaceQuad> quads);

    std::vector<DecalRow> take() { return std::move(_rows); }

private:
    glm::dvec3 _origin;
    std::vector<Decal> _decals;
    BoxTree _tree;
    std::vector<DecalRow> _rows;
};

} // namespace osgRoads::core
