// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/models/trees/Skeleton.h"

namespace scenery::models
{

/// Adds leaf cards to a skeleton: quads bent once across, each with a cluster of leaves or a spray of
/// needles. Their normals are those of the whole crown, which is so shaded as one soft body; their vertices
/// are darker the deeper they are inside it. Four triangles a card.
void addFoliage(ModelBuilder& builder, const TreeForm& form, const Skeleton& tree, Dice& dice);

} // namespace scenery::models
