// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/consolidate/InsertTVertices.h>
#include <osgPMObjects/core/consolidate/RemoveFaces.h>

namespace osgPMObjects::core
{

/// What passes over cracks go by, and on.
struct CrackPasses
{
    TVertexState tVertices;        ///< the tolerance, and how far positions have moved
    double degenerateHeight = 0.0; ///< faces no higher than this go; units: as the positions
    int most = 0;                  ///< passes at most, in all calls
    int made = 0;                  ///< passes so far
    /// Where the next pass has to look: the positions of faces that have changed; all of them the first time.
    bool isWhole = true;
    std::vector<std::uint32_t> changed{};
    /// A change of more than this share of the positions is met with a pass over the whole mesh.
    double wholeShare = 0.01;
};

/// What closeCracks() did.
struct ClosedCracks
{
    std::size_t degenerateFaces = 0; ///< removed
    DuplicateFaces duplicates;
    TVertices tVertices;
};

/// Removes degenerate and duplicate faces, puts vertices into the edges that they lie on, and again, for one makes the other,
/// until a pass does nothing or there were too many. Where the one before has changed little, a pass looks at its
/// neighbourhood only, with the result that passes over the whole mesh have.
/// Cost: a third of a second for a pass over a million faces; a tenth to find a neighbourhood, then its share for each.
/// Source: spec 3, Consolidation; the neighbourhoods are ours.
ClosedCracks closeCracks(Mesh& mesh, CrackPasses& passes);

} // namespace osgPMObjects::core
