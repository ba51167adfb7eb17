// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Report of splitNonManifoldEdges().
struct SplitEdges
{
    std::size_t crowded = 0;     ///< edges with more than two faces
    std::size_t disagreeing = 0; ///< edges whose two faces run in the same direction
    std::size_t copies = 0;      ///< positions added
};

/// Makes every edge have one face, or two of consistent orientation: positions on edges with more faces, or
/// with two that disagree, are duplicated. At an edge with more than two faces, pairs of faces stay
/// connected: those of one part and material first, then the flattest. A face that is left over gets an open
/// edge; so do pairs that are connected around both ends. Copies have the same coordinates, so images do not
/// change.
/// Source: Guéziec, Taubin, Lazarus and Horn, *Cutting and stitching: converting sets of polygons to manifold
/// surfaces* (2001), section 3 (cutting). Differs: cuts only at vertices of the marked edges.
SplitEdges splitNonManifoldEdges(Mesh& mesh);

} // namespace osgPMObjects::core
