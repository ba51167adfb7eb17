// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgPMObjects/core/simplify/RemovalSequence.h>

#include "LiveFaces.h"

namespace osgPMObjects::core
{

/// A face around a position, by its opposite side, which is a side of the hole's contour.
struct StarFace
{
    std::uint32_t slot = 0;
    std::uint32_t from = 0, to = 0;           ///< positions
    std::uint32_t fromWedge = 0, toWedge = 0; ///< of this face
    std::uint32_t ownWedge = 0;               ///< of this face, at the middle position
    glm::dvec3 area{0.0};                     ///< its area vector, of twice the area's length
};

/// Consecutive faces of a star that leave one hole: a whole fan, or a fan's faces between two seams.
struct StarSector
{
    std::uint32_t first = 0, count = 0; ///< index in VertexStar::faces
    bool isClosed = false;              ///< the last face meets the first, with the same wedges
};

/// The faces around a position in order, divided into sectors, with their flatness.
/// Source: Schroeder, Zarge and Lorensen, *Decimation of triangle meshes* (1992), section 3.2: simple,
/// boundary, interior edge and corner vertices. Differs: several fans are allowed, and attribute seams count
/// as edges.
struct VertexStar
{
    std::uint32_t position = 0;
    std::vector<StarFace> faces;
    std::vector<StarSector> sectors;
    double distance =
        0.0; ///< of the position from the mean planes of its sectors, and from the lines that divide them
};

/// Gathers the star of a position into `star`, which is undefined when the position is refused.
/// A closed fan is divided along its two edges sharper than `creaseCosine`, when there are just two.
RemovalRefusal gatherStar(const LiveFaces& live, std::uint32_t position, double creaseCosine,
                          VertexStar& star);

} // namespace osgPMObjects::core
