// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "LeafGrowth.h"

namespace osgPMObjects::core
{

/// Returns the error after a leaf has merged into another: distance at most the diagonal of the box that the
/// card may fill, and the differences of normals, texture coordinates and colours.
LevelError leafError(const CollapseState& state, const Leaf& gone, const Leaf& stays,
                     const LeafGrowth& growth);

} // namespace osgPMObjects::core
