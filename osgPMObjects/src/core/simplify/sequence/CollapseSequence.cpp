// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "FacesAfter.h"
#include "StepShare.h"

namespace osgPMObjects::core
{

std::span<const WedgeCollapse> CollapseSequence::wedgesOf(std::size_t step) const
{
    return shareOf(steps, &CollapseStep::firstWedge, wedges, step);
}

std::span<const MovedWedge> CollapseSequence::movedWedgesOf(std::size_t step) const
{
    return shareOf(steps, &CollapseStep::firstMoved, movedWedges, step);
}

namespace
{

/// Returns the least number of steps, from 0, after which `isEnough(step)` holds for the last of them.
template<class IsEnough>
std::size_t stepsUntil(const CollapseSequence& sequence, const IsEnough& isEnough)
{
    const auto last = std::partition_point(sequence.steps.begin(), sequence.steps.end(),
                                           [&](const CollapseStep& s) { return !isEnough(s); });
    return static_cast<std::size_t>(last - sequence.steps.begin());
}

} // namespace

std::size_t stepsToFaces(const CollapseSequence& sequence, std::size_t faces)
{
    if (sequence.facesBefore <= faces || sequence.steps.empty()) return 0;
    std::size_t last = stepsUntil(sequence, [&](const CollapseStep& s) { return s.facesAfter <= faces; });
    last = std::min(last, sequence.steps.size() - 1);
    std::size_t whole = last;
    while (sequence.steps[whole].goesOn)
        ++whole;
    // Steps that belong together are not separated, unless the rest of them removes a larger share of the
    // faces.
    constexpr std::size_t kMostShare = 10;
    const bool takesRest = (faces - sequence.steps[whole].facesAfter) * kMostShare <= faces;
    return (takesRest ? whole : last) + 1;
}

std::size_t stepsToDistance(const CollapseSequence& sequence, double tolerance)
{
    std::size_t steps =
        stepsUntil(sequence, [&](const CollapseStep& s) { return s.error.distance > tolerance; });
    while (steps > 0 && sequence.steps[steps - 1].goesOn)
        --steps;
    return steps;
}

Mesh meshAfter(const Mesh& mesh, const CollapseSequence& sequence, std::size_t steps)
{
    Mesh level = mesh;
    for (std::size_t step = 0; step < steps; ++step)
    {
        if (!sequence.places.empty()) level.positions[sequence.steps[step].to] = sequence.places[step];
        for (const MovedWedge& moved : sequence.movedWedgesOf(step))
            assignWedge(level, moved.wedge, moved.attributes);
    }
    const FacesAfter after(mesh, sequence, steps);
    level.faces.clear();
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        if (!after.isLeft[f]) continue;
        level.faces.push_back(mesh.faces[f]);
        for (std::uint32_t& wedge : level.faces.back().wedges)
            wedge = after.wedges[wedge];
    }
    compactMesh(level);
    return level;
}

} // namespace osgPMObjects::core
