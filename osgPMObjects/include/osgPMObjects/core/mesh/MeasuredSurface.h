// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

/// A point on a surface, in its triangle: corner 0 + second·(corner 1 - corner 0) + third·(corner 2 - corner
/// 0).
struct SurfacePoint
{
    glm::dvec3 position{};
    std::uint32_t triangle = 0; ///< of MeasuredSurface::triangles()
    double second = 0.0, third = 0.0;
};

/// A surface prepared for distance measurements: the non-degenerate faces of a mesh (kDegenerateHeight),
/// sample points on them, and a tree for nearest-point queries. The mesh must not change. Threads: queries
/// from any number at once. Memory: some 90 B a face, 48 B a point.
class MeasuredSurface
{
public:
    /// `spread`: number of points that are spread by area; always the same ones.
    explicit MeasuredSurface(const Mesh& mesh, std::size_t spread = 60000);
    MeasuredSurface(const MeasuredSurface&) = delete;
    MeasuredSurface& operator=(const MeasuredSurface&) = delete;

    const Mesh& mesh() const { return _mesh; }
    const std::vector<Triangle>& triangles() const { return _triangles; }
    const std::vector<std::uint32_t>& faces() const { return _faces; } ///< by triangle: face of the mesh
    const TriangleTree& tree() const { return _tree; }

    /// All corners and centres of faces.
    const std::vector<glm::dvec3>& fixedPoints() const { return _fixedPoints; }
    /// Points spread evenly by area, in the order of their triangles.
    const std::vector<SurfacePoint>& spreadPoints() const { return _spreadPoints; }

private:
    const glm::dvec3& at(const Triangle& t, std::size_t corner) const { return _mesh.positions[t[corner]]; }
    TriangleTree makeTree(); ///< also makes the triangles
    void addFixedPoints();
    void addSpreadPoints(std::size_t count);

    const Mesh& _mesh;
    std::vector<Triangle> _triangles;
    std::vector<std::uint32_t> _faces;
    std::vector<glm::dvec3> _fixedPoints;
    std::vector<SurfacePoint> _spreadPoints;
    TriangleTree _tree;
};

} // namespace osgPMObjects::core
