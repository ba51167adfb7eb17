// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <queue>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "CollapseState.h"
#include "Collapser.h"

namespace osgPMObjects::core
{

namespace
{

/// Parts in shares of about as many faces each: the largest first, each to the share that has least.
std::vector<std::vector<std::uint32_t>> balancedShares(const std::vector<ConnectedPart>& parts,
                                                       std::size_t shareCount)
{
    std::vector<std::uint32_t> order(parts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return parts[a].faces > parts[b].faces; });
    std::vector<std::vector<std::uint32_t>> shares(shareCount);
    std::vector<std::size_t> faces(shareCount, 0);
    for (const std::uint32_t part : order)
    {
        const auto least =
            static_cast<std::size_t>(std::min_element(faces.begin(), faces.end()) - faces.begin());
        shares[least].push_back(part);
        faces[least] += parts[part].faces;
    }
    return shares;
}

std::vector<PartialSequence> collapseAll(CollapseState& state)
{
    const std::size_t threads =
        state.parts.size() > 1 ? std::max(1u, std::thread::hardware_concurrency()) : 1;
    const auto shares = balancedShares(state.parts, threads);
    std::vector<PartialSequence> partial(shares.size());
    parallelShares(shares.size(), 1,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t i = first; i < last; ++i)
                           partial[i] = Collapser(state).run(shares[i]);
                   });
    return partial;
}

/// Appends one step of a partial sequence, in the units of the mesh.
class Merger
{
public:
    Merger(const Mesh& mesh, std::uint32_t faces) : _extent(extentOf(mesh.positions))
    {
        _whole.facesBefore = _facesLeft = faces;
    }

    void append(const CollapseSequence& part, std::size_t number)
    {
        CollapseStep step = part.steps[number];
        step.firstWedge = static_cast<std::uint32_t>(_whole.wedges.size());
        step.firstMoved = static_cast<std::uint32_t>(_whole.movedWedges.size());
        _facesLeft -= step.facesAfter;
        step.facesAfter = _facesLeft;
        const double diagonal = _extent.diagonal() > 0.0 ? _extent.diagonal() : 1.0;
        _error.distance = std::max(_error.distance, static_cast<float>(step.error.distance * diagonal));
        _error.normal = std::max(_error.normal, std::min(step.error.normal, 2.0f));
        _error.texCoord = std::max(_error.texCoord, step.error.texCoord);
        _error.colour = std::max(_error.colour, std::min(step.error.colour, 1.0f));
        step.error = _error;
        const auto wedges = part.wedgesOf(number);
        const auto moved = part.movedWedgesOf(number);
        _whole.wedges.insert(_whole.wedges.end(), wedges.begin(), wedges.end());
        _whole.movedWedges.insert(_whole.movedWedges.end(), moved.begin(), moved.end());
        if (!part.places.empty())
            _whole.places.push_back(
                glm::clamp(part.places[number] * diagonal + 0.5 * (_extent.low + _extent.high), _extent.low,
                           _extent.high));
        _whole.steps.push_back(step);
    }

    CollapseSequence finish() { return std::move(_whole); }

private:
    Extent _extent;
    CollapseSequence _whole;
    LevelError _error;
    std::uint32_t _facesLeft = 0;
};

/// Puts the steps of parts that do not touch into the order in which one queue would have done them.
CollapseSequence merged(const std::vector<PartialSequence>& partial, Merger merger)
{
    std::vector<std::size_t> next(partial.size(), 0);
    for (;;)
    {
        std::size_t first = partial.size();
        for (std::size_t i = 0; i < partial.size(); ++i)
            if (next[i] < partial[i].urgencies.size() &&
                (first == partial.size() ||
                 partial[i].urgencies[next[i]] < partial[first].urgencies[next[first]]))
                first = i;
        if (first == partial.size()) return merger.finish();
        merger.append(partial[first].sequence, next[first]++);
    }
}

} // namespace

CollapseSequence simplify(const Mesh& mesh, const SimplifySettings& settings)
{
    CollapseState state(mesh, settings);
    const std::vector<PartialSequence> partial = collapseAll(state);
    return merged(partial, Merger(mesh, state.stars.faceCount()));
}

} // namespace osgPMObjects::core
