// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <viewlod/Sight.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "compare/terrain/methods/MethodFigures.h"

namespace terraintool
{

/// The ways in which ROAM's mesh can get from one frame to a very different one.
enum class Rework
{
    wheel,    ///< the default driver
    enhMerge, ///< a walk over the last frame's tree that removes subtrees at once (the paper's loop)
    oneByOne, ///< the same walk with Duchaineau's merges, diamond after diamond
    restart,  ///< the same walk after everything has been merged to the two roots (Duchaineau's proposal)
    bareList, ///< from scratch without a mesh: a list of triangles that share nothing, as others measure it
};

inline constexpr Rework kReworks[] = {Rework::wheel, Rework::enhMerge, Rework::oneByOne, Rework::restart,
                                      Rework::bareList};

/// Names as in tables.
const char* reworkName(Rework way);

/// Adapts a tree to an eye, where it is in sight, by one of the three ways that walk. All end in the same
/// mesh: exactly the active vertices are split.
/// Precondition: `way` is enhMerge, oneByOne or restart. Returns the number of triangles split and merged.
std::uint32_t reworkTree(Rework way, osgTerrainROAM::core::DiamondTree& tree, const viewlod::ViewState& view,
                         double tolerancePx, const viewlod::Sight& sight = {});

/// Measures every way over frames that have little in common: jumps of 1 km to and fro, jumps over half of
/// the tile, and turns by 180 degrees while flying; refined all around and, as in the paper, in sight alone
/// (by position and orientation, with a margin of 5 degrees). In sight also a look around: turns by 9 degrees
/// a frame on the spot. Times are of this thread.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 5.2.
std::vector<ReworkFigures> measureReworks(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile,
                                          double tolerancePx);

} // namespace terraintool
