// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Removes faces that use a position twice, or are no higher over their longest side than `height`. Returns how many.
/// The neighbours of a flat face get its third corner from insertTVertices().
std::size_t removeDegenerateFaces(Mesh& mesh, double height);

/// What removeDuplicateFaces() found.
struct DuplicateFaces
{
    std::size_t removed = 0; ///< the same corners as a face that stays, and the same front
    std::size_t hidden = 0;  ///< of these, with another material, behind the one that stays
    std::size_t backToBack =
        0; ///< pairs that were one face's front and back: one face, drawn from both sides, stays
    std::size_t kept = 0; ///< pairs back to back of different look, which no single face shows: both stay
};

/// Of faces on the same three positions, or copies of them at the same places, keeps one; of faces with the same front the first opaque one, for it hides the others
/// where depth must be less to be drawn. Of two faces back to back that one which is drawn from both sides stays; two one-sided
/// ones of the same state become one of a two-sided material (the state with neither side culled, and lit from both); two
/// one-sided ones of different states both stay.
DuplicateFaces removeDuplicateFaces(Mesh& mesh);

} // namespace osgPMObjects::core
