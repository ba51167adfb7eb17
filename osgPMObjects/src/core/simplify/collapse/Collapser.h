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

/// The steps of some connected parts in order, with the urgency of each. `facesAfter` is the number of faces
/// that the step removed, and errors are those of the step alone.
struct PartialSequence
{
    CollapseSequence sequence;
    std::vector<Urgency> urgencies;
};

/// Collapses some connected parts to nothing, the collapse with the least Urgency first.
/// With subset placement, positions whose stars have changed are re-evaluated at once. With other placements,
/// which cost more, they are re-evaluated when they come first in the queue; except positions with harmful
/// candidates only, which might never come first. Hubs of large fans always wait.
/// Source: Cohen, Manocha and Olano, *Simplifying polygonal models using successive mappings* (1997), section
/// 5 (lazy queue).
class Collapser
{
public:
    explicit Collapser(CollapseState& state) : _state(state), _choice(state), _queue(state.positions.size())
    {
        if (state.envelope) _guard.emplace(*state.envelope, state.stars, state.positions);
    }

    /// Collapses the parts with these numbers and returns their steps.
    PartialSequence run(std::span<const std::uint32_t> parts);

private:
    void enter(std::uint32_t position);
    bool isCurrent(std::uint32_t position) const;
    bool isAllowed(std::uint32_t from, std::uint32_t to);
    void enterWhatIsAllowed(std::uint32_t position);
    bool isHasty(const Candidate& candidate) const;
    void collapse(std::uint32_t from);
    void collapseImages(std::uint32_t from, std::uint32_t to, std::uint32_t step, const Urgency& urgency);
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
