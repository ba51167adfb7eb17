// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Undoes repairs where they made a count of defects worse: T-junctions, duplicates, degenerate faces or
/// edges with more than two faces. Faces that share a position, before or after, form a group, and so do
/// those on both sides of a T-junction; a group gets back all its faces and positions. Afterwards no count of
/// the mesh is larger than before.
/// `before`: the mesh before the repairs; the repaired one must have its positions and wedges under the same
/// numbers, and may have more. `origins`: by face of the repaired mesh, rising: the face of `before` that it
/// was or comes from; brought up to date. Returns how many faces of `before` were given back. Cost: that of
/// countMesh() twice, and once for each round of groups.
std::size_t undoWorseRepairs(Mesh& mesh, const Mesh& before, std::vector<std::uint32_t>& origins);

} // namespace osgPMObjects::core
