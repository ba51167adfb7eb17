// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Clusters of leaves on their twigs, 512 × 512, cut out by alpha; the twig comes in at the middle of the lower edge.
Picture paintOakLeaves();
Picture paintBirchLeaves();
Picture paintPoplarLeaves();
Picture paintBushLeaves();

/// A spray of needles: the twig runs from the lower edge to the upper one.
Picture paintSpruceNeedles();

} // namespace scenery::models
