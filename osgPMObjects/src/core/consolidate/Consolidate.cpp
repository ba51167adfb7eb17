// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/consolidate/CloseCracks.h>
#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "MeshSnapshot.h"

namespace osgPMObjects::core
{

namespace
{

/// The most rounds of splits with the repairs that follow.
constexpr int kMostRounds = 20;

void add(ConsolidateReport& report, const ClosedCracks& more)
{
    report.degenerateFaces += more.degenerateFaces;
    report.duplicates.removed += more.duplicates.removed;
    report.duplicates.hidden += more.duplicates.hidden;
    report.duplicates.backToBack += more.duplicates.backToBack;
    report.duplicates.kept = more.duplicates.kept; // the same pairs each time
    report.tVertices.inserted += more.tVertices.inserted;
    report.tVertices.stitched += more.tVertices.stitched;
    report.tVertices.slivers += more.tVertices.slivers;
    report.tVertices.moved += more.tVertices.moved;
}

/// Reverses faces and splits edges. A split opens edges that may have T-vertices, and inserting those may make an edge non-manifold
/// again.
void orientAndSplit(Mesh& mesh, bool orient, CrackPasses& cracks, ConsolidateReport& report)
{
    for (int round = 0; round < kMostRounds; ++round)
    {
        const MeshSnapshot before(mesh);
        if (orient && round == 0) report.orientation = orientFaces(mesh);
        const SplitEdges split = splitNonManifoldEdges(mesh);
        cracks.changed = before.changedSince(mesh);
        report.splitEdges.crowded += split.crowded;
        report.splitEdges.disagreeing += split.disagreeing;
        report.splitEdges.copies += split.copies;
        if (split.copies == 0 || cracks.made >= cracks.most) return;
        add(report, closeCracks(mesh, cracks));
    }
}

} // namespace

ConsolidateReport consolidate(Mesh& mesh, const ConsolidateOptions& options)
{
    ConsolidateReport report;
    const double diagonal = diagonalOf(mesh);
    report.weldedPositions = weldPositions(mesh, options.weldTolerance * diagonal);
    CrackPasses cracks{.tVertices = {.tolerance = options.stitchTolerance * diagonal},
                       .degenerateHeight = options.degenerateHeight * diagonal,
                       .most = kMostPasses};
    add(report, closeCracks(mesh, cracks));
    orientAndSplit(mesh, options.orient, cracks, report);
    report.tVertexPasses = cracks.made;
    if (options.orient) report.insideOut = turnInsideOut(mesh);
    if (options.computeMissingNormals)
        report.facesGivenNormals = computeNormals(
            mesh, {.creaseAngleDeg = options.creaseAngleDeg, .groups = {}, .onlyMissing = true});
    report.wedges = mergeWedges(mesh, options.wedges);
    compactMesh(mesh);
    return report;
}

} // namespace osgPMObjects::core
