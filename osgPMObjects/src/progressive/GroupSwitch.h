// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/Switch.h>

#include "CullView.h"

namespace osgPMObjects
{

/// Where one view group of an object is between two levels. The cameras of the group share it: time goes on with the first of
/// them that asks in a frame.
class GroupSwitch
{
public:
    /// A camera may leave out some frames.
    static constexpr unsigned int kUnseenFrames = 4;

    /// What to draw, regardless of the alpha range. A group that nobody has asked for longer is at rest at the target: nobody saw
    /// what it was.
    const core::DrawnLevels& advance(std::uint32_t target, const CullView& view,
                                     const core::SwitchSettings& settings, std::uint32_t number);

    const core::SwitchState& state() const { return _state; }
    core::SwitchMethod method() const { return _method; }

    /// How much of a blend is the finer level's, 0 to 1.
    float finerShare() const { return _state.to < _state.from ? _state.progress : 1.0f - _state.progress; }

private:
    core::SwitchState _state;
    core::SwitchMethod _method = core::SwitchMethod::discrete;
    core::DrawnLevels _drawn;
    bool _isKnown = false;
    unsigned int _frame = 0;
    double _timeS = 0.0;
};

} // namespace osgPMObjects
