// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// A mesh whose positions and wedges stand in the order in which vsplits bring them back: step k of the sequence takes
/// the last position of those that are left, and its wedges, which are the last of the wedges. What a wedge becomes is a number
/// below its own: `parents`.
/// Wedges and positions that no face uses are left out, faces that use a position twice too.
/// Source: spec 4, "the vertex buffer holds all vertices in split order".
struct SplitOrder
{
    Mesh mesh;
    std::vector<std::uint32_t> parents; ///< by wedge; of one that no step takes, itself
    std::vector<LevelError> errors;     ///< by step
};

/// Placement has to be *subset*: places and wedges stay what they are.
SplitOrder inSplitOrder(const Mesh& mesh, const CollapseSequence& sequence);

} // namespace osgPMObjects::core
