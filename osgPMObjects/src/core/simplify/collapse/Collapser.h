// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "CollapseChoice.h"
#include "CollapseQueue.h"
#include "CollapseState.h"

namespace osgPMObjects::core
{

/// Steps of some parts, with the urgency at which each was done, in order. `facesAfter` says how many faces the step took, and
/// errors are of that step alone.
struct PartialSequence
{
    CollapseSequence sequence;
    std::vector<Urgency> urgencies;
};

/// Collapses some parts of a mesh to nothing, again and again the collapse that is wanted most.
/// With subset placement positions whose stars have changed are looked at anew at once. With places to be found, which costs
/// more and gains nothing by haste, when their turn comes; but for those that could do only harm, whose turn might never come. Hubs of large fans wait in any case.
/// Source: Cohen, Manocha and Olano, "Simplifying polygonal models using successive mappings" (1997), §5 (lazy queue).
class Collapser
{
public:
    explicit Collapser(CollapseState& state) : _state(state), _choice(state), _queue(state.positions.size())
    {
        if (state.envelope) _guard.emplace(*state.envelope, state.stars, state.positions);
    }

    PartialSequence run(std::span<const std::uint32_t> parts);

private:
    void enter(std::uint32_t position);
    bool isCurrent(std::uint32_t position) const;
    bool isAllowed(std::uint32_t from, std::uint32_t to);
    void enterWhatIsAllowed(std::uint32_t position);
    bool isHasty(const Candidate& candidate) const;
    void collapse(std::uint32_t from);
    void collapseTwin(std::uint32_t from, std::uint32_t to, const Urgency& urgency);
    void perform(std::uint32_t from, std::uint32_t to, const Urgency& urgency, const glm::dvec3* place);
    void record(std::uint32_t from, std::uint32_t to, const CollapseChoice::Effect& effect);
    void takeFaces(std::uint32_t to);
    void refreshAround(std::uint32_t position);

    CollapseState& _state;
    CollapseChoice _choice;
    CollapseQueue _queue;
    std::optional<EnvelopeGuard> _guard;
    std::vector<std::uint32_t> _ring; ///< positions whose stars change
    PartialSequence _done;
};

} // namespace osgPMObjects::core
