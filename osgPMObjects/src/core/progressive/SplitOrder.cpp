// SPDX-License-Identifier: Apache-2.0
#include "SplitOrder.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kUnnumbered = ~0u;

std::vector<Face> properFaces(const Mesh& mesh)
{
    std::vector<Face> faces;
    faces.reserve(mesh.faces.size());
    for (const Face& face : mesh.faces)
        if (!repeatsCorner({mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)}))
            faces.push_back(face);
    return faces;
}

/// The wedges and positions that faces use now, or after a step.
struct InUse
{
    std::vector<bool> positions, wedges;

    InUse(const Mesh& mesh, const std::vector<Face>& faces, const CollapseSequence& sequence)
        : positions(mesh.positions.size(), false), wedges(mesh.wedgeCount(), false)
    {
        for (const Face& face : faces)
            for (const std::uint32_t wedge : face.wedges)
                use(mesh, wedge);
        for (const WedgeCollapse& collapse : sequence.wedges)
            if (wedges[collapse.from]) use(mesh, collapse.to);
    }

private:
    void use(const Mesh& mesh, std::uint32_t wedge)
    {
        wedges[wedge] = true;
        positions[mesh.wedgePositions[wedge]] = true;
    }
};

/// Returns the steps whose position is in use, in order; other steps remove nothing that is drawn.
std::vector<std::size_t> stepsThatTake(const CollapseSequence& sequence, const InUse& inUse)
{
    std::vector<std::size_t> steps;
    for (std::size_t s = 0; s < sequence.steps.size(); ++s)
        if (inUse.positions[sequence.steps[s].from]) steps.push_back(s);
    return steps;
}

/// Returns the positions in use in split order: first those that no step removes, then the others, the first
/// removed last.
std::vector<std::uint32_t> positionsInOrder(const CollapseSequence& sequence,
                                            const std::vector<std::size_t>& steps, const InUse& inUse)
{
    std::vector<bool> goes(inUse.positions.size(), false);
    for (const std::size_t s : steps)
        goes[sequence.steps[s].from] = true;
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < goes.size(); ++p)
        if (inUse.positions[p] && !goes[p]) order.push_back(p);
    for (auto s = steps.rbegin(); s != steps.rend(); ++s)
        order.push_back(sequence.steps[*s].from);
    return order;
}

std::vector<std::uint32_t> numbersIn(const std::vector<std::uint32_t>& order, std::size_t count)
{
    std::vector<std::uint32_t> numbers(count, kUnnumbered);
    for (std::uint32_t i = 0; i < order.size(); ++i)
        numbers[order[i]] = i;
    return numbers;
}

std::vector<std::uint32_t> wedgesInOrder(const Mesh& mesh, const InUse& inUse,
                                         const std::vector<std::uint32_t>& positionNumbers)
{
    std::vector<std::uint32_t> order;
    for (std::uint32_t w = 0; w < mesh.wedgeCount(); ++w)
        if (inUse.wedges[w]) order.push_back(w);
    std::stable_sort(
        order.begin(), order.end(),
        [&](std::uint32_t a, std::uint32_t b)
        { return positionNumbers[mesh.wedgePositions[a]] < positionNumbers[mesh.wedgePositions[b]]; });
    return order;
}

} // namespace

SplitOrder inSplitOrder(const Mesh& mesh, const CollapseSequence& sequence)
{
    assert(sequence.places.empty() && sequence.movedWedges.empty());
    std::vector<Face> faces = properFaces(mesh);
    const InUse inUse(mesh, faces, sequence);
    const auto steps = stepsThatTake(sequence, inUse);
    const auto positions = positionsInOrder(sequence, steps, inUse);
    const auto positionNumbers = numbersIn(positions, mesh.positions.size());
    const auto wedges = wedgesInOrder(mesh, inUse, positionNumbers);
    const auto wedgeNumbers = numbersIn(wedges, mesh.wedgeCount());

    SplitOrder split;
    split.mesh.materials = mesh.materials;
    split.mesh.parts = mesh.parts;
    for (const std::uint32_t p : positions)
        split.mesh.positions.push_back(mesh.positions[p]);
    for (const std::uint32_t w : wedges)
    {
        Wedge wedge = wedgeOf(mesh, w);
        wedge.position = positionNumbers[wedge.position];
        appendWedge(split.mesh, wedge);
    }
    for (Face& face : faces)
        for (std::uint32_t& wedge : face.wedges)
            wedge = wedgeNumbers[wedge];
    split.mesh.faces = std::move(faces);

    split.parents.resize(wedges.size());
    std::iota(split.parents.begin(), split.parents.end(), 0u);
    for (const std::size_t s : steps)
    {
        split.errors.push_back(sequence.steps[s].error);
        for (const WedgeCollapse& collapse : sequence.wedgesOf(s))
            if (wedgeNumbers[collapse.from] != kUnnumbered)
                split.parents[wedgeNumbers[collapse.from]] = wedgeNumbers[collapse.to];
    }
    return split;
}

} // namespace osgPMObjects::core
