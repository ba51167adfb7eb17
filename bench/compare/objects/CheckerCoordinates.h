// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/Mesh.h>

namespace pmtool
{

/// Gives every face texture coordinates (set 0), as if one texture lay along the longest side of the model's
/// box: each part is projected along the axis nearest to its normal, separately for each of the six sides;
/// each such chart lies elsewhere on the texture. Where charts meet there is a seam, and positions there have
/// several wedges. It serves to measure texture drift of models without coordinates.
void addCheckerCoordinates(osgPMObjects::core::Mesh& mesh);

} // namespace pmtool
