// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "scenery/models/cockpit/Panel.h"

namespace scenery::models
{

/// Where a head looks, and how high a picture it takes, to read the instruments of a panel. Units: degrees,
/// from straight ahead.
struct PanelView
{
    double leftDeg = 0.0, upDeg = 0.0;
    double heightDeg = 0.0; ///< of a picture of kPanelAspect that just holds them all
};

inline constexpr double kPanelAspect = 16.0 / 9.0;

/// Returns it for a panel that stands upright `distanceM` ahead of the eye.
PanelView panelViewOf(std::span<const PlacedInstrument> panel, double distanceM);

} // namespace scenery::models
