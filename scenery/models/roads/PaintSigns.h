// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints the atlas of road signs (SignAtlas.h), 2048 × 1024. Alpha is the share of the tint.
Picture paintSigns();

} // namespace scenery::models
