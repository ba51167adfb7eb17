// SPDX-License-Identifier: Apache-2.0
#include "HoleFill.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "NearestSample.h"

namespace osgTerrainROAM::core
{

void fillOutside(std::span<float> heightsM, std::span<const std::uint8_t> isOutside, int columns, int rows)
{
    const auto isMarked = [](std::uint8_t outside) { return outside != 0; };
    if (std::none_of(isOutside.begin(), isOutside.end(), isMarked)) return;
    std::vector<std::uint8_t> isKnown(heightsM.size());
    for (std::size_t i = 0; i < isKnown.size(); ++i)
        isKnown[i] = std::isfinite(heightsM[i]);
    const NearestSample known(isKnown, columns, rows);
    std::size_t i = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column, ++i)
            if (isOutside[i]) heightsM[i] = heightsM[known.nearest(column, row)];
}

} // namespace osgTerrainROAM::core
