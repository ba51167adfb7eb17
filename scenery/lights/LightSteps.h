// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include <foundation/Result.h>

#include "scenery/lights/LightPoint.h"

namespace scenery
{

/// The steps of an instructor: 0 (off) to 5 (full) of each group; absent: as the light and the air ask for.
using LightSteps = std::array<std::optional<int>, kLightGroups>;

/// Returns the share of full intensity of a step, 0…5: 100, 25, 5, 1 and 0.2 % for runways, approach, centre
/// line and touchdown zone; 100, 30, 10, 3 and 1 % for all others; 0 for step 0.
/// Source: ICAO, *Doc 9157*, part 4: steps of high intensity; three steps of the others, with two below.
double shareOfStep(LightGroup group, int step);

/// Returns the step that a tower sets: by night 3, at dusk 4, by day 5 within 5 km of visibility and else
/// none. PAPI shine by day, too; obstacle lamps, beacon, street lamps and windows by night and at dusk in
/// full.
int defaultStep(LightGroup group, double sunElevationDeg, double visibilityM);

/// Returns the shares of all groups; those without a step of the instructor have the usual one.
LightLevels levelsOf(const LightSteps& steps, double sunElevationDeg, double visibilityM);

/// Reads "approach=5,papi=3" or "all=0". Names: runway, centreLine, touchdownZone, approach, papi, taxiway,
/// beacon, obstacle, street, window, all. Errors: an unknown name, a step that is no number of 0…5.
foundation::Result<LightSteps> lightStepsOf(const std::string& text);

} // namespace scenery
