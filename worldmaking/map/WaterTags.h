// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "worldmaking/map/LandMap.h"

namespace worldmaking
{

/// Tells whether an area of water flows.
bool isRiverArea(const Tags& tags);

/// Returns the width of a line of water: its tag, or a customary one. Nothing: it is no river or canal, or
/// lies underground.
std::optional<double> riverWidthM(const LandShape& shape);

} // namespace worldmaking
