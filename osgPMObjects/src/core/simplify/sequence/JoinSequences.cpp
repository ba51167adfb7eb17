// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgPMObjects/core/simplify/JoinSequences.h>

#include "FacesAfter.h"
#include "LevelErrors.h"

namespace osgPMObjects::core
{

namespace
{

/// The original numbers of positions and wedges that are left after some steps, in order.
struct Origins
{
    std::vector<std::uint32_t> positions, wedges;
};

Origins originsAfter(const Mesh& mesh, const CollapseSequence& sequence)
{
    const FacesAfter after(mesh, sequence, sequence.steps.size());
    std::vector<std::uint32_t> positionOf = mesh.wedgePositions;
    for (const MovedWedge& moved : sequence.movedWedges)
        positionOf[moved.wedge] = moved.attributes.position;
    std::vector<bool> hasWedge(mesh.wedgeCount(), false), hasPosition(mesh.positions.size(), false);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t wedge : mesh.faces[f].wedges)
        {
            if (!after.isLeft[f]) continue;
            hasWedge[after.wedges[wedge]] = true;
            hasPosition[positionOf[after.wedges[wedge]]] = true;
        }
    Origins origins;
    for (std::uint32_t i = 0; i < hasPosition.size(); ++i)
        if (hasPosition[i]) origins.positions.push_back(i);
    for (std::uint32_t i = 0; i < hasWedge.size(); ++i)
        if (hasWedge[i]) origins.wedges.push_back(i);
    return origins;
}

/// Returns the remaining position after each step, for a sequence that moves none.
std::vector<glm::dvec3> placesOf(const CollapseSequence& sequence, std::span<const glm::dvec3> positions)
{
    std::vector<glm::dvec3> places;
    for (const CollapseStep& step : sequence.steps)
        places.push_back(positions[step.to]);
    return places;
}

} // namespace

CollapseSequence firstSteps(const CollapseSequence& sequence, std::size_t steps)
{
    CollapseSequence first;
    first.facesBefore = sequence.facesBefore;
    if (steps == 0) return first;
    const auto end = [](std::size_t n) { return static_cast<std::ptrdiff_t>(n); };
    const auto wedges = sequence.wedgesOf(steps - 1);
    const auto moved = sequence.movedWedgesOf(steps - 1);
    first.steps.assign(sequence.steps.begin(), sequence.steps.begin() + end(steps));
    first.steps.back().goesOn = false;
    first.wedges.assign(sequence.wedges.data(), wedges.data() + wedges.size());
    first.movedWedges.assign(sequence.movedWedges.data(), moved.data() + moved.size());
    if (!sequence.places.empty())
        first.places.assign(sequence.places.begin(), sequence.places.begin() + end(steps));
    return first;
}

CollapseSequence joined(const Mesh& mesh, CollapseSequence first, const CollapseSequence& second)
{
    const Origins origins = originsAfter(mesh, first);
    if (!second.places.empty() || !first.places.empty())
    {
        if (first.places.empty()) first.places = placesOf(first, mesh.positions);
        std::vector<glm::dvec3> positions = mesh.positions, left;
        for (std::size_t i = 0; i < first.steps.size(); ++i)
            positions[first.steps[i].to] = first.places[i];
        for (const std::uint32_t position : origins.positions)
            left.push_back(positions[position]);
        const auto places = second.places.empty() ? placesOf(second, left) : second.places;
        first.places.insert(first.places.end(), places.begin(), places.end());
    }
    const LevelError before = first.steps.empty() ? LevelError{} : first.steps.back().error;
    const auto wedges = static_cast<std::uint32_t>(first.wedges.size());
    const auto moved = static_cast<std::uint32_t>(first.movedWedges.size());
    for (CollapseStep step : second.steps)
    {
        step.from = origins.positions[step.from];
        step.to = origins.positions[step.to];
        step.firstWedge += wedges;
        step.firstMoved += moved;
        step.error = sumOf(before, step.error);
        first.steps.push_back(step);
    }
    for (const WedgeCollapse& wedge : second.wedges)
        first.wedges.push_back({origins.wedges[wedge.from], origins.wedges[wedge.to]});
    for (MovedWedge wedge : second.movedWedges)
    {
        wedge.wedge = origins.wedges[wedge.wedge];
        wedge.attributes.position = origins.positions[wedge.attributes.position];
        first.movedWedges.push_back(wedge);
    }
    return first;
}

} // namespace osgPMObjects::core
