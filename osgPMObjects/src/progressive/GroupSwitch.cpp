// SPDX-License-Identifier: Apache-2.0
#include "GroupSwitch.h"

#include <algorithm>

namespace osgPMObjects
{

const core::DrawnLevels& GroupSwitch::advance(std::uint32_t target, const CullView& view,
                                              const core::SwitchSettings& settings, std::uint32_t number)
{
    const bool wasSeen = _isKnown && view.frame >= _frame && view.frame - _frame <= kUnseenFrames;
    const bool hasAdvanced = wasSeen && view.frame == _frame && settings.method == _method;
    if (hasAdvanced && core::takesTime(settings.method)) return _drawn;
    if (!wasSeen) _state = core::SwitchState::at(target);
    const auto stepS = static_cast<float>(wasSeen ? std::max(view.timeS - _timeS, 0.0) : 0.0);
    _drawn = core::advanceSwitch(_state, target, stepS, 1.0f, number, settings);
    _method = settings.method;
    _isKnown = true;
    _frame = view.frame;
    _timeS = view.timeS;
    return _drawn;
}

} // namespace osgPMObjects
