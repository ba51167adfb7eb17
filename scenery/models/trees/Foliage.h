// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/models/trees/Skeleton.h"

namespace scenery::models
{

/// Hangs leaf cards on a skeleton: quads bent once across, that show a cluster of leaves, a spray of needles.
/// Their normals are those of the crown as a whole, so that it is shaded as one soft body; their vertices are darker the
/// deeper they are inside it. Four triangles a card.
void addFoliage(ModelBuilder& builder, const TreeForm& form, const Skeleton& tree, Dice& dice);

} // namespace scenery::models
