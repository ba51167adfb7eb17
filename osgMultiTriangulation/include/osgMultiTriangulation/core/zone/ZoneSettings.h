// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>

namespace osgMultiTriangulation::core
{

/// Which trees are wanted around an eye. Distances are in the units of the plan (PlanFrame), metres as a
/// rule.
struct ZoneSettings
{
    double completeWithin = 1e12; ///< trees that are nearer are loaded completely
    double nothingBeyond =
        1e12; ///< trees that are farther, not at all; between the two the level falls evenly
    std::size_t memoryBytes = 0; ///< that trees and the extractions over them may take
    /// a tree stays as it is while its level is within this share of the wanted one, above or below
    double hysteresis = 0.25;
    double mostBytesPerS = std::numeric_limits<double>::infinity(); ///< reading is slowed down to this rate
};

/// An eye over the surface.
struct ZoneEye
{
    double x = 0.0, y = 0.0; ///< on the lattice
    /// A tree is wanted only where it, or one below it, can be too coarse: where the greatest error of its
    /// root is more than this share of its distance. 0: at any distance.
    double errorPerDistance = 0.0;
    double nearest = 0.0; ///< what is nearer counts as at this distance
};

} // namespace osgMultiTriangulation::core
