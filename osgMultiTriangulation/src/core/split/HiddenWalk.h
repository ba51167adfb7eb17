// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgMultiTriangulation/core/build/MeasuredMesh.h>
#include <osgMultiTriangulation/core/structure/MultiTriangulation.h>

namespace osgMultiTriangulation::core
{

/// Returns the distance of a point from a triangle along the vertical, rounded up. Metres.
float verticalDistance(const SurfacePoint& point, const SurfacePoint& a, const SurfacePoint& b,
                       const SurfacePoint& c);

/// Finds the exact errors of a tree from all points below it, one point at a time: a point goes from its
/// triangle of the drain up, from star to floor, to the root, and raises the error of each triangle on its
/// way. So a tree that was built with some of its points gets the errors over all of them, whatever their
/// number.
/// Memory: none but the tree. Cost of a point: the fragments above it.
class HiddenWalk
{
public:
    /// Starts over: errors of triangles that the tree has created become 0, those of its drain stay.
    explicit HiddenWalk(MultiTriangulation& tree);

    /// Takes a point that lies in a triangle of the drain. Returns its triangle in the root. `errorM`:
    /// becomes its error there.
    std::uint32_t climb(const SurfacePoint& point, std::uint32_t triangle, float& errorM);

    /// Takes the vertex of a fragment.
    std::uint32_t climbFrom(std::uint32_t fragment, float& errorM);

    /// Rounds all errors up to those that a file can hold.
    void finish();

private:
    std::uint32_t floorUnder(const SurfacePoint& point, std::uint32_t fragment, float& errorM);

    MultiTriangulation& _tree;
};

/// Some hidden points of each triangle: the worst, and others by chance.
/// Memory: 24 B for each point that may be kept.
class HiddenSelection
{
public:
    /// `perTriangle`: at most so many of each.
    HiddenSelection(std::uint32_t triangles, std::uint32_t perTriangle);

    void add(std::uint32_t triangle, const SurfacePoint& point, float errorM);

    /// Gives a mesh the points that were chosen, in place of those it has. Equal sets of points give equal
    /// choices, in any order.
    void moveInto(MeasuredMesh& mesh);

private:
    struct Kept
    {
        SurfacePoint point;
        float errorM;
        std::uint32_t chance; ///< a hash of the place
    };

    std::uint32_t _perTriangle;
    std::vector<std::vector<Kept>> _kept; ///< by triangle; the worst first, the rest in the order of chance
};

} // namespace osgMultiTriangulation::core
