// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "../star/StarMesh.h"

namespace osgPMObjects::core
{

namespace
{

bool neverFalls(const LevelError& before, const LevelError& after)
{
    return before.distance <= after.distance && before.normal <= after.normal &&
           before.texCoord <= after.texCoord && before.colour <= after.colour;
}

bool indicesAreThere(const CollapseSequence& sequence, const Mesh& mesh)
{
    const auto isWedge = [&](std::uint32_t wedge) { return wedge < mesh.wedgeCount(); };
    std::uint32_t wedges = 0, moved = 0;
    for (const CollapseStep& step : sequence.steps)
    {
        if (step.from >= mesh.positions.size() || step.to >= mesh.positions.size() || step.from == step.to)
            return false;
        if (step.firstWedge < wedges || step.firstMoved < moved) return false;
        wedges = step.firstWedge;
        moved = step.firstMoved;
    }
    return wedges <= sequence.wedges.size() && moved <= sequence.movedWedges.size() &&
           (sequence.places.empty() || sequence.places.size() == sequence.steps.size()) &&
           std::all_of(sequence.wedges.begin(), sequence.wedges.end(),
                       [&](const WedgeCollapse& w) { return isWedge(w.from) && isWedge(w.to); }) &&
           std::all_of(sequence.movedWedges.begin(), sequence.movedWedges.end(),
                       [&](const MovedWedge& m) { return isWedge(m.wedge); });
}

/// Makes some levels in the public way and compares their numbers of faces.
bool levelsHaveTheirFaces(const CollapseSequence& sequence, const Mesh& mesh)
{
    constexpr std::size_t kLevels = 8;
    for (std::size_t level = 1; level <= kLevels; ++level)
    {
        const std::size_t steps = sequence.steps.size() * level / kLevels;
        const std::size_t faces = steps == 0 ? sequence.facesBefore : sequence.steps[steps - 1].facesAfter;
        if (meshAfter(mesh, sequence, steps).faces.size() != faces) return false;
    }
    return true;
}

} // namespace

bool isSequenceOf(const CollapseSequence& sequence, const Mesh& mesh)
{
    if (!indicesAreThere(sequence, mesh)) return false;
    StarMesh stars(mesh);
    if (stars.faceCount() != sequence.facesBefore) return false;
    std::vector<std::uint32_t> positionOfWedge = mesh.wedgePositions;
    std::vector<bool> isGone(mesh.positions.size(), false);
    LevelError error;
    std::uint32_t faces = sequence.facesBefore;
    for (std::size_t s = 0; s < sequence.steps.size(); ++s)
    {
        const CollapseStep& step = sequence.steps[s];
        if (isGone[step.from] || isGone[step.to] || !neverFalls(error, step.error)) return false;
        isGone[step.from] = true;
        error = step.error;
        for (const MovedWedge& moved : sequence.movedWedgesOf(s))
            positionOfWedge[moved.wedge] = moved.attributes.position;
        faces -= stars.collapse(step.from, step.to, sequence.wedgesOf(s));
        if (faces != step.facesAfter) return false;
        bool isWhole = true; // every corner at the remaining position has a wedge there
        stars.visitStar(step.to, [&](std::uint32_t face, int corner)
                        { isWhole &= positionOfWedge[stars.wedges(face)[corner]] == step.to; });
        if (!isWhole) return false;
    }
    return levelsHaveTheirFaces(sequence, mesh);
}

} // namespace osgPMObjects::core
