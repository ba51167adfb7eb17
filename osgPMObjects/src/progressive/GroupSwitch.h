// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/Switch.h>

#include "CullView.h"

namespace osgPMObjects
{

/// The switch of one view group of an object from one level to another. The cameras of the group share it:
/// time advances once a frame, with the first camera that asks.
class GroupSwitch
{
public:
    /// A group may miss so many frames without being reset.
    static constexpr unsigned int kUnseenFrames = 4;

    /// Advances the switch and returns what to draw, without the alpha range. A group that missed more frames
    /// is at rest at the target, as no camera showed the level before.
    const core::DrawnLevels& advance(std::uint32_t target, const CullView& view,
                                     const core::SwitchSettings& settings, std::uint32_t number);

    const core::SwitchState& state() const { return _state; }
    core::SwitchMethod method() const { return _method; }

    /// The share of the finer level in a blend, 0 to 1.
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
