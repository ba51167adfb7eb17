// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/Model.h"
#include "scenery/models/paint/Picture.h"

namespace foundation
{
class KeptResults;
}

namespace scenery
{

/// Returns models::mipChain() of models::paint(), painted or found among the kept ones: the same bytes.
std::vector<models::Picture> paintedChain(models::Painting painting, bool isFoliage,
                                          const foundation::KeptResults& kept,
                                          const models::VehicleLook* look = nullptr);

} // namespace scenery
