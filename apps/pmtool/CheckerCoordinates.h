// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/Mesh.h>

namespace pmtool
{

/// Gives every face texture coordinates (set 0), as if one texture lay along the longest side of the model's box: each part is
/// projected along the axis that its face looks along most, to each of the six sides apart, each such chart somewhere else on the
/// texture. Where charts meet there is a seam, and positions there have several wedges.
/// For measuring texture drift: models whose pictures are missing have no coordinates.
void addCheckerCoordinates(osgPMObjects::core::Mesh& mesh);

} // namespace pmtool
