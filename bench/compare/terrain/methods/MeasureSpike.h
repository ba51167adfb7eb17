// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

#include "compare/terrain/methods/MeasureRival.h"

namespace terraintool
{

/// Measures how many triangles one raised sample adds to each method's mesh, at its tolerance for the first
/// eye, and writes `spikeTriangles`. The sample lies where that eye sees little detail, and is raised by two
/// cells. The methods prepare only a part of the square, some 256 cells around the sample, once with it and
/// once without. `tile`: that of the square. Errors: as prepareRivals().
foundation::Outcome measureSpike(const osgTerrainROAM::core::HeightField& square,
                                 const osgTerrainROAM::core::PlacedTile& tile, const ComparedFlight& flight,
                                 std::vector<MethodFigures>& methods);

} // namespace terraintool
