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

/// What consolidate() does. Distances are shares of the mesh's diagonal.
struct ConsolidateOptions
{
    double weldTolerance = 1e-6; ///< positions nearer than this are one: the noise of floats
    double stitchTolerance =
        1.01e-5; ///< T-vertices nearer to an edge than this are put into it: those that count (1e-5), and
                 ///< those that would when positions have become floats
    double degenerateHeight = 1e-7;    ///< faces no higher than this go
    bool orient = true;                ///< make neighbours agree, turn what is inside out
    bool computeMissingNormals = true; ///< for lit faces without
    double creaseAngleDeg = 45.0;
    WedgeTolerance wedges;
};

/// What consolidate() found and did: nothing that goes, comes or moves is missing here.
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
    std::size_t facesGivenNormals = 0;
    MergedWedges wedges;

    /// Faces of the input that are no more, however they went. Faces that were cut in two are not among them.
    std::size_t facesDropped() const
    {
        return degenerateFaces + duplicates.removed + duplicates.backToBack + tVertices.slivers;
    }
};

/// From what an importer delivers to a mesh that can be simplified and drawn well: positions welded, degenerate and duplicate
/// faces removed, T-vertices inserted, neighbours oriented alike, closed groups turned outside out, edges left with two faces at
/// most, missing normals made, needless attribute splits merged. The order of faces stays.
/// Afterwards no T-junction, duplicate of the same look or degenerate face is left, unless the report says that the passes ran
/// out (kMostPasses), after which a model at hand has none left either; no position has moved farther than the two tolerances together.
/// Cost: a million triangles in some 3 s. Source: spec 3, Consolidation.
ConsolidateReport consolidate(Mesh& mesh, const ConsolidateOptions& options = {});

constexpr int kMostPasses = 20;

} // namespace osgPMObjects::core
