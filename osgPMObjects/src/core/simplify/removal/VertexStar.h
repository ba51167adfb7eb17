// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgPMObjects/core/simplify/RemovalSequence.h>

#include "LiveFaces.h"

namespace osgPMObjects::core
{

/// One face around a position, and its side opposite: a side of the contour of the hole.
struct StarFace
{
    std::uint32_t slot = 0;
    std::uint32_t from = 0, to = 0;           ///< positions
    std::uint32_t fromWedge = 0, toWedge = 0; ///< of this face
    std::uint32_t ownWedge = 0;               ///< of this face, at the position itself
    glm::dvec3 area{0.0};                     ///< its area vector, twice as long
};

/// Consecutive faces of a star that become one hole: all of a fan, or what lies between a fan's seams.
struct StarSector
{
    std::uint32_t first = 0, count = 0; ///< in VertexStar::faces
    bool isClosed = false;              ///< its last face meets its first, with the same wedges
};

/// The faces around a position in order, cut into sectors, and how flat they are.
/// Source: Schroeder, Zarge and Lorensen (1992), §3.2: simple, boundary, interior edge and corner vertices; ours may have several
/// fans, and take seams of attributes for edges.
struct VertexStar
{
    std::uint32_t position = 0;
    std::vector<StarFace> faces;
    std::vector<StarSector> sectors;
    double distance =
        0.0; ///< of the position from the mean planes of its sectors and the lines along which they are cut
};

/// Looks at a position as it is now. `star` is filled anew; what it says holds only when nothing is refused.
/// Edges between faces of a sector are flatter than `creaseCosine`, when just two of a closed fan are not.
RemovalRefusal gatherStar(const LiveFaces& live, std::uint32_t position, double creaseCosine,
                          VertexStar& star);

} // namespace osgPMObjects::core
