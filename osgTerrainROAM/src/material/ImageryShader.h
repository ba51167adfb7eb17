// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace osgTerrainROAM
{

/// GLSL of imagery in several resolutions: vec4 layeredImagery(vec2 grid), what texture() of one drape is: colour and coverage.
/// The finer lies over the coarser; towards its border it fades, over a fiftieth of its extent.
/// Samplers imageryLayer0 … and imageryFromGrid[], coarsest first.
std::string imageryGlsl(int layers);

} // namespace osgTerrainROAM
