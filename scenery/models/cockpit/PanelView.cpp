// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/cockpit/PanelView.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <glm/common.hpp>

namespace scenery::models
{

PanelView panelViewOf(std::span<const PlacedInstrument> panel, double distanceM)
{
    constexpr double kMargin = 1.15; ///< around the instruments
    glm::dvec2 low(INFINITY), high(-INFINITY);
    for (const PlacedInstrument& placed : panel)
    {
        low = glm::min(low, placed.middle - placed.radiusM);
        high = glm::max(high, placed.middle + placed.radiusM);
    }
    const glm::dvec2 middle = 0.5 * (low + high), half = 0.5 * kMargin * (high - low);
    const double awayM = std::hypot(distanceM, middle.x, middle.y);
    PanelView view;
    view.leftDeg = foundation::degreesOf(std::atan2(-middle.x, distanceM));
    view.upDeg = foundation::degreesOf(std::atan2(middle.y, std::hypot(distanceM, middle.x)));
    view.heightDeg = 2.0 * foundation::degreesOf(std::atan(std::max(half.y, half.x / kPanelAspect) / awayM));
    return view;
}

} // namespace scenery::models
