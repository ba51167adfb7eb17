// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// A sample of the tile's raster by its linear index row·side + column; side: of the padded raster.
using SampleIndex = std::uint32_t;

/// The exact nested error bounds and radii of every split vertex of the bintree over a tile's raster, in 3D.
/// (Vertices between the samples of a finer grid have none, until edits put samples there: BoundsUpdate.) e_v
/// is the largest |X(s) − Σ b_k X_k| over all *data* samples s in the two triangles of v's diamond (b
/// barycentric in grid indices), nested: e_v ≥ e_c for each child c. r_v is nested in the same way: r_v ≥
/// |X_v − X_c| + r_c. Both are rounded up to values that the tile's SampleTable can store.
/// Invariant: isNested(). Threads: immutable after construction. Memory: 8 B per sample of the tile.
/// Cost: every sample is visited once per level, 2n times; about 0.3 µs a sample in all.
/// Source: Lindstrom & Pascucci, *Visualization of large terrains made easy*, 2001 (nesting of error and
/// radius).
class ErrorTree
{
public:
    /// Exceeds the rounding of double arithmetic, so that nesting holds in the predicate, too.
    static constexpr double kRadiusSlack = 1.0 + 2e-7;

    /// Measures with two threads; the result does not depend on them.
    explicit ErrorTree(const PlacedTile& tile);

    float errorM(SampleIndex v) const { return _errorsM[v]; }
    float radiusM(SampleIndex v) const { return _radiiM[v]; }

    bool isNested(const PlacedTile& tile) const;

private:
    std::vector<float> _errorsM;
    std::vector<float> _radiiM;
};

} // namespace osgTerrainROAM::core
