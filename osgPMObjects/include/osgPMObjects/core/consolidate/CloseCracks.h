// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/consolidate/InsertTVertices.h>
#include <osgPMObjects/core/consolidate/RemoveFaces.h>

namespace osgPMObjects::core
{

/// State that successive passes over the cracks of a mesh share.
struct CrackPasses
{
    TVertexState tVertices;        ///< the tolerance, and how far positions have moved
    double degenerateHeight = 0.0; ///< faces up to this height are removed; units: as the positions
    int most = 0;                  ///< limit of passes, over all calls
    int made = 0;                  ///< passes so far
    /// Whether the next pass examines the whole mesh, or only the positions of changed faces.
    bool isWhole = true;
    std::vector<std::uint32_t> changed{};
    /// When a larger share of the positions has changed, the next pass examines the whole mesh.
    double wholeShare = 0.01;
};

/// Report of closeCracks().
struct ClosedCracks
{
    std::size_t degenerateFaces = 0; ///< removed
    DuplicateFaces duplicates;
    TVertices tVertices;
};

/// Removes degenerate and duplicate faces and inserts T-vertices into the edges on which they lie. Each
/// creates work for the other, so passes repeat until one changes nothing or their limit is reached. When a
/// pass has changed little, the next examines only the neighbourhood; the result is the same as with passes
/// over the whole mesh.
/// Cost: a third of a second for a pass over a million faces; a tenth to find a neighbourhood, then its share
/// for each.
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11), Consolidation.
/// Differs: passes over neighbourhoods.
ClosedCracks closeCracks(Mesh& mesh, CrackPasses& passes);

} // namespace osgPMObjects::core
