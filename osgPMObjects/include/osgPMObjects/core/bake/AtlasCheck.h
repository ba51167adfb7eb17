// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <osgPMObjects/core/bake/PackCharts.h>

namespace osgPMObjects::core
{

/// What keeps an atlas from being one: faces that no chart or several have, a face that lies outside, a texel with its centre in
/// two faces, a texel that a face touches nearer than `gutterPx` to the border of the picture or than twice that to one of
/// another chart. Empty: nothing does. Looks at texels one by one, apart from how charts are made and packed.
/// Cost: linear in the texels, times the gutter's area.
std::string defectOf(const Mesh& mesh, const Atlas& atlas, int gutterPx);

} // namespace osgPMObjects::core
