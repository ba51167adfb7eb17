// SPDX-License-Identifier: Apache-2.0
#include "GroupLevels.h"

namespace osgPMObjects
{

void GroupLevels::make(const core::DrawnLevels& drawn, unsigned int frame,
                       std::optional<unsigned int> contextId)
{
    makeMorph(drawn);
    if (drawn.second.alpha > 0.0f) return makeStill(drawn, frame, contextId);
    _still = nullptr;
    makeLevel(drawn.first.level, frame, contextId);
}

/// Makes both levels of a blend. The index buffer is at one of them already; this one is copied, and the
/// buffer goes on to the other. So a blend costs the steps of one switch, in whichever direction it runs.
void GroupLevels::makeStill(const core::DrawnLevels& drawn, unsigned int frame,
                            std::optional<unsigned int> contextId)
{
    const std::uint32_t a = drawn.first.level, b = drawn.second.level;
    const bool isOneOfThem = _drawn && (_drawn->steps == a || _drawn->steps == b);
    const std::uint32_t here = isOneOfThem ? _drawn->steps : a;
    const std::uint32_t other = here == a ? b : a;
    if (_still && _still->steps() == other) return makeLevel(here, frame, contextId);
    makeLevel(here, frame, contextId);
    _still = std::make_shared<StillLevel>(*_level, here);
    makeLevel(other, frame, contextId);
}

void GroupLevels::makeMorph(const core::DrawnLevels& drawn)
{
    const std::uint32_t finer = drawn.first.level;
    if (drawn.second.alpha > 0.0f || drawn.coarser <= finer)
        _morph = nullptr;
    else if (!_morph || !_morph->isBetween(finer, drawn.coarser))
        _morph = std::make_shared<MorphArrays>(_level->shape(), finer, drawn.coarser);
}

void GroupLevels::makeLevel(std::uint32_t steps, unsigned int frame, std::optional<unsigned int> contextId)
{
    DrawnLevelPtr drawn = _level->at(steps, frame, contextId);
    if (drawn == _drawn && _morph == _partsMorph) return;
    _drawn = std::move(drawn);
    _partsMorph = _morph;
    _parts.clear();
    for (std::uint32_t group = 0; group < _drawn->groupEnds.size(); ++group)
        if (!_drawn->rangesOf(group).empty()) _parts.push_back(new LevelPart(_level, _drawn, group, _morph));
}

const GroupLevels::Parts& GroupLevels::partsOf(std::uint32_t steps) const
{
    return _still && _still->steps() == steps ? _still->parts() : _parts;
}

void GroupLevels::releaseGLObjects(osg::State* state)
{
    _level->releaseGLObjects(state);
    // What OSG has uploaded of these is released with them; they are made again when they are needed.
    _still = nullptr;
    _morph = nullptr;
    if (!_partsMorph) return;
    _partsMorph = nullptr;
    _parts.clear();
    _drawn = nullptr;
}

} // namespace osgPMObjects
