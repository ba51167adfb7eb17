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

/// All that is painted on a network, to be found by place. Threads: const, any.
class DecalFinder
{
public:
    explicit DecalFinder(const PlacedNetwork& network);

    /// Returns the decals that lie on any of the quads, in the order of decals().
    std::vector<std::uint32_t> on(std::span<const SurfaceQuad> quads) const;

    const std::vector<Decal>& decals() const { return _decals; }

private:
    std::vector<Decal> _decals;
    BoxTree _tree;
};

/// Writes what is painted on pieces of the surface into lists for the shader. A decal belongs to every
/// surface that it lies on, whichever road that is of: a crosswalk at the end of a road reaches into the
/// junction.
class DecalRows
{
public:
    /// `origin`: of the mesh. `finder` must outlive it.
    DecalRows(const DecalFinder& finder, const glm::dvec3& origin)
        : _finder(finder), _origin(origin), _rows(1)
    {
    }

    /// Returns the row of the list of what lies on any of the quads; 0: nothing.
    std::uint32_t listFor(std::span<const SurfaceQuad> quads);

    std::vector<DecalRow> take() { return std::move(_rows); }

private:
    const DecalFinder& _finder;
    glm::dvec3 _origin;
    std::vector<DecalRow> _rows;
};

} // namespace osgRoads::core
