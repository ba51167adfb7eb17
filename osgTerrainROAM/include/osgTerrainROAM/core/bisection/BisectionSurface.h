// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include <osgTerrainROAM/core/bisection/Bisector.h>

namespace osgTerrainROAM::core
{

/// Where a point of the coarse mesh lies on the true surface: a sphere's radius, a terrain's height, any
/// deformation. A function of the point alone, so faces agree along their sides.
using SurfaceShape = std::function<glm::dvec3(const glm::dvec3& coarsePoint)>;

/// The corners of a triangle: left, right, apex; counter-clockwise.
using CornerVertices = std::array<std::uint32_t, 3>;

/// Where a point lies in a triangle: shares of left, right and apex. They are sums of powers of a half, so
/// they are exact.
using CornerWeights = std::array<glm::dvec3, 3>;
constexpr CornerWeights kOwnCorners{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};

inline glm::dvec3 middleOf(const CornerWeights& corners)
{
    return 0.5 * (corners[0] + corners[1]);
}

/// The vertices that the bintrees over a coarse mesh can have, down to a level. A vertex has one number,
/// whichever triangle asks: points of the mesh come first, then centres of faces, then the middle of each
/// base.
/// Memory: 24 B a triangle of the complete bintrees.
class BisectionSurface
{
public:
    /// `levels`: of the finest triangles, 1 … 24; the complete bintrees have less than 2^31 triangles.
    BisectionSurface(CoarseMesh mesh, int levels, const SurfaceShape& shape);

    const CoarseMesh& mesh() const { return _mesh; }
    int levels() const { return _levels; }

    /// Returns the number of the vertex that splits a triangle above the last level. `at`: its neighbours.
    std::uint32_t vertexOf(const BisectorNeighbours& at) const;
    std::uint32_t vertexOf(Bisector t) const { return vertexOf(neighboursOf(_mesh, t)); }

    CornerVertices cornersOf(Bisector t) const;
    CornerVertices rootCorners(std::uint32_t side) const;

    std::uint32_t vertices() const { return static_cast<std::uint32_t>(_points.size()); }
    const glm::dvec3& point(std::uint32_t vertex) const { return _points[vertex]; }

    /// Calls visit(neighbours, vertex, corners) for a triangle and all below it that are above the last
    /// level; the vertex lies at middleOf(corners). Where it returns false, the halves are left out.
    /// `corners`: of the first, as shares of any triangle above it.
    template<class Visit>
    void visitWeighted(const BisectorNeighbours& at, const CornerWeights& corners, const Visit& visit) const
    {
        if (at.self.level() >= _levels) return;
        if (!visit(at, vertexOf(at), corners)) return;
        const glm::dvec3 middle = middleOf(corners);
        visitWeighted(at.half(0), {corners[2], corners[0], middle}, visit);
        visitWeighted(at.half(1), {corners[1], corners[2], middle}, visit);
    }

    /// Calls visit(vertex) for all vertices that there are, for some twice. Numbers of others have no place.
    template<class Visit>
    void forEachVertex(const Visit& visit) const
    {
        for (std::uint32_t vertex = 0; vertex < _firstMiddle; ++vertex)
            visit(vertex);
        for (std::uint32_t side = 0; side < _mesh.sides(); ++side)
            visitWeighted(neighboursOf(_mesh, {side, 1}), kOwnCorners,
                          [&](const auto&, std::uint32_t vertex, const auto&)
                          {
                              visit(vertex);
                              return true;
                          });
    }

private:
    CoarseMesh _mesh;
    int _levels;
    std::uint32_t _firstMiddle;
    std::vector<glm::dvec3> _points; ///< by vertex
};

} // namespace osgTerrainROAM::core
