// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// A mesh in split order: positions and wedges stand in the order in which vertex splits bring them back.
/// Each step removes the last position left and its wedges, which are the last wedges; `parents` gives the
/// lower wedge that replaces each. Positions and wedges that no face uses, and faces that use a position
/// twice, are left out.
/// Source: *Cache-friendly view-independent progressive meshes* (Graphicon 2003), section 4; Forsyth,
/// "Comparison of VIPM methods" (2001).
struct SplitOrder
{
    Mesh mesh;
    std::vector<std::uint32_t> parents; ///< by wedge; itself if no step removes it
    std::vector<LevelError> errors;     ///< by step
};

/// Reorders a mesh. The sequence must have *subset* placement: positions and wedges do not change.
SplitOrder inSplitOrder(const Mesh& mesh, const CollapseSequence& sequence);

} // namespace osgPMObjects::core
