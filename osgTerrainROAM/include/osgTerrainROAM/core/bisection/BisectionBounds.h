// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/bisection/BisectionPatch.h>

namespace osgTerrainROAM::core
{

/// Where the surface is seen from.
struct BisectionView
{
    glm::dvec3 eye{0.0};
    double tolerance = 0.001; ///< error for a unit of distance: pixels over pixels of a unit of tangent
    double nearest = 1.0;     ///< the least distance that counts
};

/// For each vertex the error that is left without it, and the radius around it in which that error lies; both
/// nested, so that what a vertex depends on is active whenever it is. The error of a triangle is the greatest
/// distance of a point of the finest surface in it from the triangle's point of the same weights: of all
/// vertices at the finest level, and in a carrier of all points of its patch. Both surfaces are linear
/// between those points, so it bounds all others.
/// Memory: 8 B a triangle of the complete bintrees. Cost: one step for each vertex at each level.
/// Source: Lindstrom & Pascucci, *Terrain simplification simplified*, 2002, section 4 (nested errors and
/// spheres).
class BisectionBounds
{
public:
    BisectionBounds(const BisectionSurface& surface, std::span<const BisectionPatch> patches);

    float error(std::uint32_t vertex) const { return _errors[vertex]; }
    float radius(std::uint32_t vertex) const { return _radii[vertex]; }

    /// Whether a vertex is needed: the error without it would be seen.
    bool isActive(std::uint32_t vertex, const BisectionView& view) const;

private:
    void measure(Bisector t, std::span<const BisectionPatch> patches, const CarrierTable& carriers);

    const BisectionSurface& _surface;
    std::vector<float> _errors, _radii; ///< by vertex
};

} // namespace osgTerrainROAM::core
