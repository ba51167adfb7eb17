// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <viewlod/Budget.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/blocks/BlockErrors.h>

namespace osgTerrainROAM::core
{

/// What each block may be off: an error in metres, for an eye or for all.
struct AllowedErrors
{
    /// For an eye: K e / max(d, n) <= tolerance, with d the least distance from the eye to the block
    /// (screenErrorBoundPx).
    AllowedErrors(const BlockErrors& errors, const viewlod::ViewState& view);

    /// The same for all blocks.
    AllowedErrors(const BlockErrors& errors, double errorM) : perTolerance(errors.grid().count(), errorM) {}

    std::vector<double> perTolerance; ///< by block; times the tolerance
};

/// The level of each block, with a share of the way to the next while it morphs: a whole number without
/// morphing.
using BlockLevels = std::vector<double>;

/// Chooses for each block the coarsest level whose error is allowed; then blocks become finer where a finer
/// neighbour's border would be off by more than that neighbour may. Levels of neighbours may differ by any
/// number. The choice depends on errors and allowances alone.
BlockLevels chooseLevels(const BlockErrors& errors, const AllowedErrors& allowed, double tolerance);

/// Chooses levels that change continuously with the allowance: level k + f, where the block is drawn f of the
/// way from level k to the next, has the error (1 - f) e(k) + f e(k+1). Levels of neighbours differ by at
/// most one, so that every state of a block lies between two of its meshes of which one refines the other.
BlockLevels chooseMorphedLevels(const BlockErrors& errors, const AllowedErrors& allowed, double tolerance);

/// How a block is drawn at these levels.
BlockShape shapeAt(const BlockGrid& grid, const BlockLevels& levels, std::uint32_t block);

/// The level of a border: the coarser of its two blocks.
double borderLevel(const BlockGrid& grid, const BlockLevels& levels, std::uint32_t block, int side);

/// The levels within a ceiling of triangles, and the tolerance that they reach.
struct LevelsInCeiling
{
    BlockLevels levels;
    double tolerance = 0.0;
    std::uint32_t triangles = 0;
};

/// Finds the least tolerance from `target` up, to one part in ten thousand, at which the triangles are not
/// more than `most`.
LevelsInCeiling levelsInCeiling(const BlockErrors& errors, const AllowedErrors& allowed, double target,
                                std::uint32_t most, bool morphs);

} // namespace osgTerrainROAM::core
