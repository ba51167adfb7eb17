// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

/// A place on a surface, by the triangle it lies on: corner 0 + second·(corner 1 - corner 0) + third·(corner 2 - corner 0).
struct SurfacePoint
{
    glm::dvec3 position{};
    std::uint32_t triangle = 0; ///< of MeasuredSurface::triangles()
    double second = 0.0, third = 0.0;
};

/// The surface of a mesh, made ready to be compared with others: its faces that are no degenerates (kDegenerateHeight), places on
/// it, and a tree to find the nearest.
/// The mesh must stay as it is. Threads: questions from any number at once. Memory: some 90 B a face, 48 B a place.
class MeasuredSurface
{
public:
    /// `spread`: how many points are spread by area; the same ones each time.
    explicit MeasuredSurface(const Mesh& mesh, std::size_t spread = 60000);
    MeasuredSurface(const MeasuredSurface&) = delete;
    MeasuredSurface& operator=(const MeasuredSurface&) = delete;

    const Mesh& mesh() const { return _mesh; }
    const std::vector<Triangle>& triangles() const { return _triangles; }
    const std::vector<std::uint32_t>& faces() const { return _faces; } ///< of the mesh, by triangle
    const TriangleTree& tree() const { return _tree; }

    /// Every corner and centre of a face.
    const std::vector<glm::dvec3>& fixedPoints() const { return _fixedPoints; }
    /// Points spread by area, in the order of their triangles.
    const std::vector<SurfacePoint>& spreadPoints() const { return _spreadPoints; }

private:
    const glm::dvec3& at(const Triangle& t, std::size_t corner) const { return _mesh.positions[t[corner]]; }
    TriangleTree makeTree(); ///< and the triangles
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
