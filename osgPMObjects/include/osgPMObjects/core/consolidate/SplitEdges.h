// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// What splitNonManifoldEdges() did.
struct SplitEdges
{
    std::size_t crowded = 0;     ///< edges with more than two faces
    std::size_t disagreeing = 0; ///< edges whose two faces run the same way along them
    std::size_t copies = 0;      ///< positions added
};

/// Makes every edge have at most two faces, which run against each other along it: positions on edges that have more, or two
/// that disagree, are doubled. At a crowded edge faces stay joined in pairs, those first that belong to one part and one
/// material, then the flattest; a face that is left over gets an open edge, and so do pairs that hang
/// together around both ends. Copies stand where the original stands: pictures do
/// not change.
/// Afterwards every edge has one face, or two that agree.
/// Source: Guéziec, Taubin, Lazarus and Horn, "Cutting and stitching: converting sets of polygons to manifold surfaces" (2001), §3
/// (cutting); we cut at the vertices of the marked edges only.
SplitEdges splitNonManifoldEdges(Mesh& mesh);

} // namespace osgPMObjects::core
