// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Report of orientFaces(). A patch is a set of faces connected by edges of two consistently oriented faces.
struct Orientation
{
    std::size_t patches = 0;
    std::size_t doubtful = 0;    ///< patches with a neighbour of opposite orientation
    std::size_t unjudged = 0;    ///< of these, judged by few rays or none: too many, or among too many faces
    std::size_t turnedFaces = 0; ///< faces of reversed patches
    std::size_t disagreements =
        0; ///< remaining edges whose two faces have the same direction: folds and Möbius strips, to be cut
};

/// Reverses patches until neighbours have consistent orientation, as far as possible. Rays decide which of
/// two neighbours is wrong: the side that is visible from outside is the front. Where both sides are visible
/// (a sheet), a patch follows its largest neighbour that it does not fold back onto; without one it stays as
/// it is.
/// Remaining disagreements are no errors: a folded cuff, visible from outside on both sides, keeps both
/// fronts, and splitNonManifoldEdges() cuts it at the fold.
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11),
/// Consolidation: neighbours of any start polygon are flipped. Differs: visibility decides, after Takayama et
/// al. (2014), see Visibility.h. The lecture's rule alone, from the largest area, turned cuffs of the model
/// pirate and the hull of CG-57 black.
/// Cost: linear; a tree of the triangles, and 48 rays a side for the 2 048 largest doubtful patches, each of
/// which looks at no more than 1 024 boxes of that tree on average; all together at 50 million.
Orientation orientFaces(Mesh& mesh);

/// Report of turnInsideOut().
struct InsideOut
{
    std::size_t closedGroups = 0; ///< sets of faces connected by edges with two faces, without an open edge
    std::size_t turnedGroups = 0; ///< of these, with negative volume: reversed
    std::size_t cavities = 0;     ///< of these, with negative volume inside another closed group: correct
};

/// Reverses closed groups with negative volume as a whole, unless they are the inner wall of a hollow body.
/// Flat groups have no inside: their volume is below a millionth of that of a cube with their area.
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11), Consolidation.
/// Differs: inner walls.
InsideOut turnInsideOut(Mesh& mesh);

/// Reverses one face. Normals that agreed with the face are negated; normals that pointed to its back were
/// right, and stay. A face that is drawn from both sides looks the same either way: its normals are negated
/// only if `isCertain`, or if its material lights backs as such. Other faces that used its wedges keep them.
void turnFace(Mesh& mesh, std::uint32_t face, bool isCertain);

} // namespace osgPMObjects::core
