// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/file/MtInfo.h>

namespace osgMultiTriangulation::core
{

/// The extents of the trees of a file in an R-tree of Boost.Geometry.
/// Threads: any number may ask at once.
class TreeIndex
{
public:
    explicit TreeIndex(std::span<const MtEntry> trees);

    /// Returns the numbers of the trees whose extent meets a rectangle, ascending. `x`, `y`: its middle, on
    /// the lattice.
    std::vector<std::uint32_t> near(double x, double y, double halfWidth, double halfHeight) const;

private:
    struct Boxes; // the R-tree: its headers stay in the source
    std::shared_ptr<const Boxes> _boxes;
};

/// The distance of a place on the lattice from a tree's extent, in the units of the steps; 0 inside.
double distanceTo(const MtEntry& tree, double x, double y, double stepX = 1.0, double stepY = 1.0);

} // namespace osgMultiTriangulation::core
