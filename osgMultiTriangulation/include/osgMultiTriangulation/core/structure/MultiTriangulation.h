// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A fragment: the star of one vertex, which replaces the triangles of its floor. Star and floor cover the
/// same area.
struct Fragment
{
    std::uint32_t firstTriangle = 0; ///< of its star; the others follow
    std::uint32_t firstFloor = 0;    ///< in MultiTriangulation::floors
    std::uint8_t triangleCount = 0;
    std::uint8_t floorCount = 0;

    bool operator==(const Fragment&) const = default;
};

/// A multi-triangulation: the coarsest triangulation of a surface (the root), and fragments that refine it up
/// to the input (the drain). A fragment may be applied once all triangles of its floor are there. The order
/// of fragments is one in which all can be applied, so each prefix of them is a multi-triangulation too.
/// Triangles: those of the root, then the stars of the fragments in order. Points: those of the root, then
/// the vertex of each fragment in order. A triangle's *upper* fragment has it in its star, its *lower* one in
/// its floor.
/// Invariant: checkStructure() in StructureCheck.h.
/// Memory: 28 B a triangle, 24 B a fragment; about 4 triangles a point.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 2;
/// De Floriani, Magillo & Puppo, *Efficient implementation of multi-triangulations* (1998). Differs: the root
/// is always the coarsest.
struct MultiTriangulation
{
    std::vector<SurfacePoint> points;
    std::vector<Triangle> corners; ///< by triangle
    std::vector<float> errors; ///< by triangle, metres: bounds its distance from the input along the vertical
    std::vector<std::uint32_t> lower; ///< by triangle, or kNone: it is one of the drain
    std::vector<std::uint32_t> upper; ///< by triangle, or kNone: it is one of the root
    std::vector<Fragment> fragments;
    std::vector<std::uint32_t> floors;
    std::uint32_t rootTriangles = 0;
    std::uint32_t rootPoints = 0;

    std::span<const std::uint32_t> floorOf(std::uint32_t fragment) const
    {
        return std::span(floors).subspan(fragments[fragment].firstFloor, fragments[fragment].floorCount);
    }

    bool operator==(const MultiTriangulation&) const = default;

    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(corners.size()); }
};

} // namespace osgMultiTriangulation::core
