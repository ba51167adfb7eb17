// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/drivers/BenchSquare.h"

#include "measurement/flights/RasterCrop.h"

namespace terraintool
{

using namespace osgTerrainROAM::core;

foundation::Result<HeightField> squareOf(const HeightField& all, const SquareChoice& choice,
                                         const std::string& file)
{
    // A side alone leaves the corner where it is for the largest square.
    measurement::RasterCrop square =
        measurement::rasterCrop(all, choice.crop.size() == 3 ? choice.crop : std::vector<int>());
    if (!choice.crop.empty()) square.side = choice.crop[0];
    square.cellM = choice.cellM.value_or(square.cellM);
    if (square.side < 3 || !square.isPartOf(all))
        return foundation::Error{file, "the square is no part of the raster, or too small",
                                 "choose at least 3 samples within it"};
    return square.of(all);
}

} // namespace terraintool
