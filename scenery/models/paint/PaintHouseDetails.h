// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints the atlas of houses/DetailAtlas.h, 1024 × 1024. Alpha is the share of the tint: window frames and
/// doors, not glass.
Picture paintHouseDetails();

} // namespace scenery::models
