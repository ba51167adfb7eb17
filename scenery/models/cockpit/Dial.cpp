// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/cockpit/Dial.h"

#include <cmath>

namespace scenery::models
{

double handAngleDeg(const DialHand& hand, double value)
{
    const std::vector<DialPoint>& scale = hand.scale;
    const DialPoint& first = scale.front();
    if (!std::isfinite(value)) return first.angleDeg;
    if (hand.motion == DialMotion::round)
    {
        const double turn = (value - first.value) / (scale[1].value - first.value);
        return first.angleDeg + (scale[1].angleDeg - first.angleDeg) * (turn - std::floor(turn));
    }
    if (value <= first.value) return first.angleDeg;
    for (std::size_t i = 1; i < scale.size(); ++i)
        if (value < scale[i].value)
        {
            const double share = (value - scale[i - 1].value) / (scale[i].value - scale[i - 1].value);
            return scale[i - 1].angleDeg + share * (scale[i].angleDeg - scale[i - 1].angleDeg);
        }
    return scale.back().angleDeg;
}

} // namespace scenery::models
