// SPDX-License-Identifier: Apache-2.0
#include <numeric>
#include <utility>

#include <osgPMObjects/core/consolidate/CloseCracks.h>
#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "MeshSnapshot.h"
#include "UndoRepairs.h"

namespace osgPMObjects::core
{

namespace
{

/// The most rounds of splits with the repairs that follow.
constexpr int kMostRounds = 20;
/// The most faces that inserted T-vertices may add: known models get less than a tenth.
constexpr std::size_t kMostGrowth = 2, kSmallGrowth = 4096;

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

/// Closes cracks. `origins`: by face, the number that it had at first; brought up to date.
void closeAndFollow(Mesh& mesh, CrackPasses& cracks, std::vector<std::uint32_t>& origins,
                    ConsolidateReport& report)
{
    const FaceOrigins numbers(mesh);
    add(report, closeCracks(mesh, cracks));
    std::vector<std::uint32_t> now = numbers.giveBack(mesh);
    for (std::uint32_t& face : now)
        face = origins[face];
    origins = std::move(now);
}

/// Reverses faces and splits edges. A split opens edges that may have T-vertices, and inserting those may
/// make an edge non-manifold again.
void orientAndSplit(Mesh& mesh, bool orient, CrackPasses& cracks, std::vector<std::uint32_t>& origins,
                    ConsolidateReport& report)
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
        closeAndFollow(mesh, cracks, origins, report);
    }
}

/// Reverses faces and splits edges after repairs were undone, where that makes no count worse.
void orientAndSplitWhatIsBack(Mesh& mesh, bool orient, ConsolidateReport& report)
{
    if (orient) report.orientation = orientFaces(mesh);
    const Mesh before = mesh;
    std::vector<std::uint32_t> origins(mesh.faces.size());
    std::iota(origins.begin(), origins.end(), 0u);
    report.splitEdges.copies += splitNonManifoldEdges(mesh).copies;
    undoWorseRepairs(mesh, before, origins);
}

bool isAnyCountWorse(const MeshCounts& now, const MeshCounts& before)
{
    return now.tJunctions > before.tJunctions || now.duplicates > before.duplicates ||
           now.degenerates > before.degenerates || now.nonManifoldEdges > before.nonManifoldEdges;
}

/// Gives the whole input back where all of its faces are back, or a count is still worse than before: among
/// faces that cross by the thousand the searches for T-junctions are cut short, so that groups of faces
/// cannot be compared.
void giveBackWhatIsWorse(Mesh& mesh, const Mesh& input, ConsolidateReport& report)
{
    const bool isAllBack = report.facesAsTheyWere == input.faces.size();
    if (!isAllBack && !isAnyCountWorse(countMesh(mesh), countMesh(input))) return;
    mesh = input;
    const int passes = report.tVertexPasses;
    report = {};
    report.tVertexPasses = passes;
    report.facesAsTheyWere = input.faces.size();
}

/// Closes cracks, reverses faces and splits edges. Where the passes do not come to an end, as among cards
/// closer to each other than the tolerance, or would add too many faces, as where edges cross by the
/// thousand, they may leave more defects than there were: such faces are put back.
void repair(Mesh& mesh, const Mesh& input, CrackPasses& cracks, bool orient, ConsolidateReport& report)
{
    std::vector<std::uint32_t> origins(mesh.faces.size());
    std::iota(origins.begin(), origins.end(), 0u);
    closeAndFollow(mesh, cracks, origins, report);
    orientAndSplit(mesh, orient, cracks, origins, report);
    report.tVertexPasses = cracks.made;
    if (cracks.made < cracks.most && !cracks.tVertices.isAtLimit) return;
    report.facesAsTheyWere = undoWorseRepairs(mesh, input, origins);
    if (report.facesAsTheyWere > 0 && report.facesAsTheyWere < input.faces.size())
        orientAndSplitWhatIsBack(mesh, orient, report);
    giveBackWhatIsWorse(mesh, input, report);
}

} // namespace

ConsolidateReport consolidate(Mesh& mesh, const ConsolidateOptions& options)
{
    ConsolidateReport report;
    const double diagonal = diagonalOf(mesh);
    const Mesh input = mesh;
    report.weldedPositions = weldPositions(mesh, options.weldTolerance * diagonal);
    CrackPasses cracks{.tVertices = {.tolerance = options.stitchTolerance * diagonal,
                                     .mostNewFaces = kMostGrowth * mesh.faces.size() + kSmallGrowth},
                       .degenerateHeight = options.degenerateHeight * diagonal,
                       .most = kMostPasses};
    repair(mesh, input, cracks, options.orient, report);
    if (options.orient) report.insideOut = turnInsideOut(mesh);
    if (options.computeMissingNormals)
        report.facesGivenNormals = computeNormals(
            mesh, {.creaseAngleDeg = options.creaseAngleDeg, .groups = {}, .onlyMissing = true});
    report.wedges = mergeWedges(mesh, options.wedges);
    compactMesh(mesh);
    return report;
}

} // namespace osgPMObjects::core
