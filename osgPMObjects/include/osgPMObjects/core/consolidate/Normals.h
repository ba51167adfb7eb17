// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// How smooth normals are made.
struct Smoothing
{
    double creaseAngleDeg = 45.0; ///< faces that meet at a sharper angle keep an edge
    /// By face, a set of bits as in 3DS and OBJ files: only faces with a common bit are smoothed together, whatever the angle;
    /// 0: with none. Empty: the crease angle decides.
    std::span<const std::uint32_t> groups;
    bool onlyMissing = true; ///< faces whose corners all have a normal keep theirs
};

/// Gives the corners of faces normals: the mean of the faces around, weighted by the angle of their corner there, over those
/// that are joined with the face across smooth edges. An edge is smooth where exactly two faces meet that agree in orientation
/// and are not kept apart by crease or groups. New wedges are made where faces that shared one differ. Lit materials only, unless
/// all are asked for: what is not lit needs none.
/// Returns how many faces were given normals. Needs consistent orientation to mean something, see orientFaces().
/// Source: spec 3, Consolidation 4; Thürmer and Wüthrich, "Computing vertex normals from polygonal facets" (1998), for the weights.
std::size_t computeNormals(Mesh& mesh, const Smoothing& smoothing);

} // namespace osgPMObjects::core
