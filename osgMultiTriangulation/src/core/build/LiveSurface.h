// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/build/MeasuredMesh.h>

#include "HoleTriangulation.h"

namespace osgMultiTriangulation::core
{

/// The star of a vertex: its triangles in counter-clockwise order, and the ring around them. On the border of the surface the ring
/// has a corner more than the star has triangles.
struct LiveStar
{
    static constexpr int kMost = HoleTriangulation::kMostCorners;

    int triangles = 0, corners = 0;
    std::array<std::uint32_t, kMost> slots; ///< of the triangles
    std::array<std::uint32_t, kMost> ring;  ///< vertices
    std::array<std::uint32_t, kMost>
        across; ///< the slot beyond the side from ring[i] to the next corner, or kNone
};

/// The triangulation while vertices are removed, with neighbours and with the removed points in each triangle.
/// Memory: 32 B a point, 40 B a triangle.
class LiveSurface
{
public:
    struct Vertex
    {
        double x, y, height;
        std::uint32_t triangle; ///< the slot of one of its triangles, kNone once it is removed
        std::uint32_t next;     ///< of the removed points in the same triangle
    };

    struct Face
    {
        Triangle corners;
        Triangle across; ///< the slot beyond the side from corner i to the next, or kNone
        float error;     ///< greatest over the points in it
        std::uint32_t firstPoint;
        std::uint32_t pointCount;
        std::uint32_t number; ///< by creation; kNone: the slot is empty
    };

    explicit LiveSurface(const MeasuredMesh& input);

    const Vertex& vertex(std::uint32_t v) const { return _vertices[v]; }
    const Face& face(std::uint32_t slot) const { return _faces[slot]; }
    std::uint32_t slots() const { return static_cast<std::uint32_t>(_faces.size()); }

    /// Gathers the star of a vertex that is there. Returns false when the vertex has to stay: more corners than
    /// LiveStar::kMost, a corner of the surface's outline.
    bool gatherStar(std::uint32_t v, LiveStar& star) const;

    /// Removes a vertex: `pieces` (corners by their place in the ring) take the place of its star. They are numbered from
    /// `firstNumber`, in order. The points of the star and the vertex are moved into them.
    void replaceStar(std::uint32_t v, const LiveStar& star, std::span<const HoleTriangulation::Piece> pieces,
                     std::uint32_t firstNumber);

private:
    void link(const LiveStar& star, std::span<const HoleTriangulation::Piece> pieces);
    std::uint32_t takePoints(std::uint32_t v, const LiveStar& star);
    void addPoint(std::uint32_t slot, std::uint32_t point);
    bool contains(const Face& face, const Vertex& point) const;

    std::vector<Vertex> _vertices; ///< points of the mesh, then hidden points
    std::vector<Face> _faces;
};

} // namespace osgMultiTriangulation::core
