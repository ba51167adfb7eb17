// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Settings of computeNormals().
struct Smoothing
{
    double creaseAngleDeg = 45.0; ///< edges between faces at a sharper angle are creases
    /// By face: a set of bits, the smoothing groups of 3DS and OBJ files. Only faces with a common bit are
    /// smoothed together, at any angle. Empty: the crease angle decides.
    std::span<const std::uint32_t> groups;
    bool onlyMissing = true; ///< faces whose corners all have a normal keep theirs
};

/// Computes vertex normals: the mean of the face normals around a corner, weighted by the corner's angle,
/// over the faces that are connected with its own across smooth edges. An edge is smooth when it has exactly
/// two faces of consistent orientation and is no crease. Wedges are split where their faces get different
/// normals. Only lit materials get normals, unless all are asked for. Returns the number of faces that got
/// normals. The mesh should have consistent orientation, see orientFaces().
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11), Consolidation; weights: Thürmer and Wüthrich, *Computing vertex normals from polygonal
/// facets* (1998).
std::size_t computeNormals(Mesh& mesh, const Smoothing& smoothing);

} // namespace osgPMObjects::core
