// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints a cluster of leaves on its twig, 512 × 512, cut out by alpha; the twig enters at the middle of the
/// lower edge.
Picture paintOakLeaves();
Picture paintBirchLeaves();
Picture paintPoplarLeaves();
Picture paintBushLeaves();

/// Paints a spray of needles; its twig runs from the lower to the upper edge.
Picture paintSpruceNeedles();

} // namespace scenery::models
