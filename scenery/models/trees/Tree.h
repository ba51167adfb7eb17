// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/Model.h"
#include "scenery/models/trees/TreeForm.h"

namespace scenery::models
{

/// Generates a tree: closed limbs with bark, and leaf cards. Pure. Surfaces: bark, leaves. Triangles: 3 000
/// to 15
/// 000. Its roots reach kRootM into the ground.
Model makeTree(TreeKind kind, std::uint64_t seed);

} // namespace scenery::models
