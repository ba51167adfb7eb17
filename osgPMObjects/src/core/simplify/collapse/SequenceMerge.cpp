// SPDX-License-Identifier: Apache-2.0
#include "SequenceMerge.h"

#include <utility>

#include "../sequence/LevelErrors.h"

namespace osgPMObjects::core
{

namespace
{

/// A sequence to which steps are appended one by one.
class Whole
{
public:
    Whole(const UnitFrame& frame, std::uint32_t faces, std::size_t steps, std::size_t wedges)
        : _frame(frame), _facesLeft(faces)
    {
        _sequence.facesBefore = faces;
        _sequence.steps.reserve(steps);
        _sequence.wedges.reserve(wedges);
    }

    void append(const CollapseSequence& part, std::size_t number)
    {
        CollapseStep step = part.steps[number];
        const auto wedges = part.wedgesOf(number);
        const auto moved = part.movedWedgesOf(number);
        step.firstWedge = static_cast<std::uint32_t>(_sequence.wedges.size());
        step.firstMoved = static_cast<std::uint32_t>(_sequence.movedWedges.size());
        _facesLeft -= step.facesAfter;
        step.facesAfter = _facesLeft;
        step.error = _error = raisedBy(step.error, _frame.diagonal(), _error);
        _sequence.wedges.insert(_sequence.wedges.end(), wedges.begin(), wedges.end());
        _sequence.movedWedges.insert(_sequence.movedWedges.end(), moved.begin(), moved.end());
        if (!part.places.empty()) _sequence.places.push_back(_frame.placed(part.places[number]));
        _sequence.steps.push_back(step);
    }

    CollapseSequence finish() { return std::move(_sequence); }

private:
    const UnitFrame& _frame;
    CollapseSequence _sequence;
    LevelError _error;
    std::uint32_t _facesLeft;
};

} // namespace

CollapseSequence mergedSequence(std::span<const PartialSequence> partial, const UnitFrame& frame,
                                std::uint32_t facesBefore)
{
    std::size_t steps = 0, wedges = 0;
    for (const PartialSequence& part : partial)
    {
        steps += part.sequence.steps.size();
        wedges += part.sequence.wedges.size();
    }
    Whole whole(frame, facesBefore, steps, wedges);
    std::vector<std::size_t> next(partial.size(), 0);
    for (;;)
    {
        std::size_t least = partial.size();
        for (std::size_t i = 0; i < partial.size(); ++i)
            if (next[i] < partial[i].urgencies.size() &&
                (least == partial.size() ||
                 partial[i].urgencies[next[i]] < partial[least].urgencies[next[least]]))
                least = i;
        if (least == partial.size()) return whole.finish();
        const CollapseSequence& sequence = partial[least].sequence;
        for (bool goesOn = true; goesOn;)
        {
            goesOn = sequence.steps[next[least]].goesOn;
            whole.append(sequence, next[least]++);
        }
    }
}

} // namespace osgPMObjects::core
