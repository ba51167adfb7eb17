// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <osgPMObjects/core/bake/PackCharts.h>

namespace osgPMObjects::core
{

/// Checks an atlas; returns a description of the first defect, or an empty string. Defects are a face in no
/// chart or in several, a face outside of the image, a texel with its centre in two faces, and a texel of a
/// face nearer than `gutterPx` to the border of the image or than twice that to a texel of another chart. The
/// check is texel by texel and independent of packing.
/// Cost: linear in the texels, times the gutter's area.
std::string defectOf(const Mesh& mesh, const Atlas& atlas, int gutterPx);

} // namespace osgPMObjects::core
