// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Removes faces that use a position twice, or whose height over the longest side is at most `height`.
/// Returns their number. insertTVertices() then inserts the third corner of a flat face into its neighbours.
std::size_t removeDegenerateFaces(Mesh& mesh, double height);

/// Report of removeDuplicateFaces().
struct DuplicateFaces
{
    std::size_t removed = 0;    ///< faces with the corners and front of a remaining face
    std::size_t hidden = 0;     ///< of these, with another material, hidden by the remaining face
    std::size_t backToBack = 0; ///< pairs of front and back that became one face drawn from both sides
    std::size_t kept = 0;       ///< pairs of front and back with different looks, which both remain
};

/// Removes duplicates: faces on the same three positions, or on copies of them at the same points. Of faces
/// with the same front the first opaque one remains: it hides the others when the depth test is "less". Of
/// two faces back to back, the one drawn from both sides remains. Two one-sided faces of one state become one
/// of a two-sided material (neither side culled, lit from both); two of different states both remain.
DuplicateFaces removeDuplicateFaces(Mesh& mesh);

} // namespace osgPMObjects::core
