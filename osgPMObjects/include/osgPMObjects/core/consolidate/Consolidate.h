// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/consolidate/InsertTVertices.h>
#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/consolidate/Normals.h>
#include <osgPMObjects/core/consolidate/Orient.h>
#include <osgPMObjects/core/consolidate/RemoveFaces.h>
#include <osgPMObjects/core/consolidate/SplitEdges.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Options of consolidate(). Distances are shares of the mesh's diagonal.
struct ConsolidateOptions
{
    double weldTolerance = 1e-6; ///< positions closer than this are merged: the rounding error of floats
    double stitchTolerance =
        1.01e-5; ///< T-vertices within it count as such: 1e-5, and more for positions that become floats
    double degenerateHeight = 1e-7;    ///< faces up to this height are removed
    bool orient = true;                ///< orient neighbours alike, and closed groups outwards
    bool computeMissingNormals = true; ///< for faces of lit materials
    double creaseAngleDeg = 45.0;
    WedgeTolerance wedges;
};

/// Report of consolidate(): everything that was removed, added or moved.
struct ConsolidateReport
{
    std::size_t weldedPositions = 0;
    std::size_t degenerateFaces = 0; ///< removed
    DuplicateFaces duplicates;
    TVertices tVertices;
    int tVertexPasses = 0;
    Orientation orientation;
    InsideOut insideOut;
    SplitEdges splitEdges;
    /// Number of faces of the input left as they were, since repairs among them made a count of defects
    /// worse.
    std::size_t facesAsTheyWere = 0;
    std::size_t facesGivenNormals = 0;
    MergedWedges wedges;

    /// Number of faces of the input that were removed, for any reason. Faces that were cut in two do not
    /// count.
    std::size_t facesDropped() const
    {
        return degenerateFaces + duplicates.removed + duplicates.backToBack + tVertices.slivers;
    }
};

/// Makes an imported mesh fit for simplification and drawing: welds positions, removes degenerate and
/// duplicate faces, inserts T-vertices, orients neighbours alike and closed groups outwards, splits
/// non-manifold edges, computes missing normals, and merges needless attribute splits. Faces keep their
/// order. Afterwards the mesh has no T-junction, no degenerate face and no duplicate of equal look, unless
/// the report says that the limit of passes (kMostPasses) or of new faces was reached. Even then no count is
/// larger than before: groups of faces that would have more are left as they were. No position moves farther
/// than both tolerances together; in knots of positions nearer to each other than the tolerances up to four
/// times as far.
/// Cost: a million triangles in some 3 s.
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11), Consolidation.
ConsolidateReport consolidate(Mesh& mesh, const ConsolidateOptions& options = {});

constexpr int kMostPasses = 20;

} // namespace osgPMObjects::core
