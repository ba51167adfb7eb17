// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// What orientFaces() did. A patch: faces joined across edges with two faces that agree.
struct Orientation
{
    std::size_t patches = 0;
    std::size_t doubtful = 0;    ///< patches that disagree with a neighbour
    std::size_t turnedFaces = 0; ///< in patches that were turned
    std::size_t disagreements =
        0; ///< edges on which two faces still run the same way: folds and Möbius strips, to be cut
};

/// Turns patches of faces that disagree with their neighbours, so that, as far as it can be, neighbours run against each other
/// along their edge. Which of two is wrong the open decides: rays tell from which side a patch can be seen from outside, and that
/// is its front. Where both sides can be seen (a sheet), a patch follows the largest neighbour that it does not fold back onto.
/// What still disagrees then is no mistake: a cuff turned back, seen from outside on both its sides, keeps both fronts, and
/// splitNonManifoldEdges() cuts it at the fold.
/// Patches without such a neighbour stay as they are, however they stand.
/// Source: spec 3, Consolidation 3 (neighbours of any start polygon are flipped); the open as a judge is Takayama et al. (2014), see
/// Visibility.h. The lecture's rule alone, with the largest area as the start, turned pirate's cuffs and CG-57's hull to black.
/// Cost: linear; a tree of the triangles, and 48 rays a side for the 2 048 largest doubtful patches.
Orientation orientFaces(Mesh& mesh);

/// What turnInsideOut() did.
struct InsideOut
{
    std::size_t closedGroups =
        0; ///< groups of faces joined across edges with two faces, without an open edge
    std::size_t turnedGroups = 0; ///< of these, with negative volume
    std::size_t cavities =
        0; ///< of these, with negative volume, but inside another closed group: as they should be
};

/// Turns closed groups with negative volume as a whole, unless they are the inner wall of a hollow body. Flat groups, whose
/// volume is a millionth of a cube's of their area, have no inside.
/// Source: spec 3, Consolidation 3; cavities are ours.
InsideOut turnInsideOut(Mesh& mesh);

/// Turns one face round. Its normals turn with it where they agreed with it before; where they pointed to the back they were
/// right, and stay. Of a face that is drawn from both sides, which looks the same either way round, they turn only if it is certain
/// that it stood the wrong way, or if backs are lit as such. Faces that shared its wedges keep theirs.
void turnFace(Mesh& mesh, std::uint32_t face, bool isCertain);

} // namespace osgPMObjects::core
