// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

namespace osgPMObjects::core
{

namespace
{

/// Flat faces between vertices on one line can be cut by each pass into ones that the next removes, for ever: after so many
/// passes they go instead of being cut.
constexpr int kPatientPasses = 6;

void add(DuplicateFaces& sum, const DuplicateFaces& more)
{
    sum.removed += more.removed;
    sum.hidden += more.hidden;
    sum.backToBack += more.backToBack;
    sum.kept = more.kept; // the same pairs each time
}

void add(TVertices& sum, const TVertices& more)
{
    sum.inserted += more.inserted;
    sum.stitched += more.stitched;
    sum.slivers += more.slivers;
    sum.moved += more.moved;
}

/// Removes what is no face, puts vertices into the edges they lie on, and again, for one makes the other.
void closeCracks(Mesh& mesh, double diagonal, const ConsolidateOptions& options, TVertexState& state,
                 ConsolidateReport& report)
{
    while (report.tVertexPasses < kMostPasses)
    {
        ++report.tVertexPasses;
        report.degenerateFaces += removeDegenerateFaces(mesh, options.degenerateHeight * diagonal);
        add(report.duplicates, removeDuplicateFaces(mesh));
        const TVertices pass = insertTVertices(mesh, state);
        add(report.tVertices, pass);
        if (pass.isNothing()) return;
        if (report.tVertexPasses >= kPatientPasses) state.thinHeight = state.tolerance;
    }
}

/// A split opens edges that others may lie on, and what is put into those can crowd an edge again.
void splitEdges(Mesh& mesh, double diagonal, const ConsolidateOptions& options, TVertexState& state,
                ConsolidateReport& report)
{
    for (int round = 0; round < kMostPasses; ++round)
    {
        const SplitEdges split = splitNonManifoldEdges(mesh);
        report.splitEdges.crowded += split.crowded;
        report.splitEdges.disagreeing += split.disagreeing;
        report.splitEdges.copies += split.copies;
        if (split.copies == 0 || report.tVertexPasses >= kMostPasses) return;
        closeCracks(mesh, diagonal, options, state, report);
    }
}

} // namespace

ConsolidateReport consolidate(Mesh& mesh, const ConsolidateOptions& options)
{
    ConsolidateReport report;
    const double diagonal = diagonalOf(mesh);
    report.weldedPositions = weldPositions(mesh, options.weldTolerance * diagonal);
    TVertexState state{.tolerance = options.stitchTolerance * diagonal};
    closeCracks(mesh, diagonal, options, state, report);
    if (options.orient) report.orientation = orientFaces(mesh);
    splitEdges(mesh, diagonal, options, state, report);
    if (options.orient) report.insideOut = turnInsideOut(mesh);
    if (options.computeMissingNormals)
        report.facesGivenNormals = computeNormals(
            mesh, {.creaseAngleDeg = options.creaseAngleDeg, .groups = {}, .onlyMissing = true});
    report.wedges = mergeWedges(mesh, options.wedges);
    compactMesh(mesh);
    return report;
}

} // namespace osgPMObjects::core
