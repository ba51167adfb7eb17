// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/build/MeasuredMesh.h>

#include "HoleMeasure.h"

namespace osgMultiTriangulation::core
{

/// The star of a vertex: its triangles in counter-clockwise order, and the ring around them. On the border of
/// the surface the ring has a corner more than the star has triangles.
struct LiveStar
{
    static constexpr int kMost = HoleTriangulation::kMostCorners;

    int triangles = 0, corners = 0;
    std::array<std::uint32_t, kMost> slots; ///< of the triangles
    std::array<std::uint32_t, kMost> ring;  ///< vertices
    std::array<std::uint32_t, kMost>
        across; ///< the slot beyond the side from ring[i] to the next corner, or kNone
};

/// The triangulation while vertices are removed, with neighbours and with the removed points in each
/// triangle. The points of a triangle lie side by side, so that a walk over them does not wait for memory.
/// When some go to other triangles all of the star are written anew, behind the others; when there is no more
/// room, what is left is put together.
/// Memory: 4 B a vertex, 40 B a triangle, 32 B a point that is or will be removed, and 16 B more while they
/// are put together.
class LiveSurface
{
public:
    static constexpr std::size_t kWorst = 4; ///< of the points of each triangle lie in front, the worst first

    struct Face
    {
        Triangle corners;
        Triangle across; ///< the slot beyond the side from corner i to the next, or kNone
        float error;     ///< greatest over the points in it
        std::uint32_t firstPoint;
        std::uint32_t pointCount;
        std::uint32_t number; ///< by creation; kNone: the slot is empty
    };

    /// `input` must stay.
    explicit LiveSurface(const MeasuredMesh& input);

    const SurfacePoint& point(std::uint32_t v) const { return _points[v]; }
    bool isThere(std::uint32_t v) const { return _triangleOf[v] != kNone; }
    const Face& face(std::uint32_t slot) const { return _faces[slot]; }
    std::uint32_t slots() const { return static_cast<std::uint32_t>(_faces.size()); }
    std::span<const SurfacePoint> removedIn(std::uint32_t slot) const
    {
        return std::span(_removed).subspan(_faces[slot].firstPoint, _faces[slot].pointCount);
    }

    /// Gathers the star of a vertex that is there. Returns false when the vertex has to stay: more corners
    /// than LiveStar::kMost, a corner of the surface's outline.
    bool gatherStar(std::uint32_t v, LiveStar& star) const;

    /// Removes a vertex: `pieces` (corners by their place in the ring) take the place of its star. They are
    /// numbered from `firstNumber`, in order. The points of the star and the vertex are moved into them.
    /// `pieceOf`: by point, that of the vertex first, then those of the star's triangles.
    void replaceStar(std::uint32_t v, const LiveStar& star, std::span<const HoleTriangulation::Piece> pieces,
                     std::uint32_t firstNumber, std::span<const std::uint8_t> pieceOf);

private:
    /// A triangle of a hole while it gets its points.
    struct Filled
    {
        std::array<const SurfacePoint*, 3> corners;
        std::array<double, kWorst> worst; ///< errors of those in front, falling
        double area;
        std::uint32_t first, next; ///< in _removed
    };

    void link(const LiveStar& star, std::span<const HoleTriangulation::Piece> pieces);
    void makeRoom(std::size_t count);
    void put(Filled& piece, const SurfacePoint& point);

    std::span<const SurfacePoint> _points;
    std::vector<std::uint32_t>
        _triangleOf; ///< by vertex: the slot of one of its triangles, kNone once it is removed
    std::vector<Face> _faces;
    std::vector<SurfacePoint> _removed; ///< points of faces; it never grows beyond its capacity
};

} // namespace osgMultiTriangulation::core
