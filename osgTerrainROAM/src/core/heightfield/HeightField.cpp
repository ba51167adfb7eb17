// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace osgTerrainROAM::core
{

bool HeightField::isComplete() const
{
    if (columns < 2 || rows < 2) return false;
    if (heightsM.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) return false;
    return std::all_of(heightsM.begin(), heightsM.end(), [](float h) { return std::isfinite(h); });
}

} // namespace osgTerrainROAM::core
