// SPDX-License-Identifier: Apache-2.0
#include "TriangulatedRaster.h"

#include <algorithm>
#include <string>
#include <utility>

#include <foundation/SmallLetters.h>

#include <osgMultiTriangulation/core/follow/SampledSurface.h>

namespace osgTerrainROAM::core
{

namespace
{

namespace mt = osgMultiTriangulation::core;

constexpr int kMostSampledSide = 4097;

/// A plane in metres whose numbers are no degrees, however small.
constexpr const char* kPlaneWkt = "LOCAL_CS[\"plan\",UNIT[\"metre\",1]]";

/// Places samples that are `pitchX`, `pitchY` lattice steps apart, from the surface's south-west on.
void place(Raster& raster, const mt::MtInfo& info, double pitchX, double pitchY)
{
    const mt::PlanFrame units = mt::inReference(info.frame);
    const mt::MtEntry& main = info.trees[0];
    raster.frame =
        GridFrame{units.originX + units.stepX * main.low[0], units.originY + units.stepY * main.low[1],
                  units.stepX * pitchX, units.stepY * pitchY};
    raster.crsWkt = info.frame.reference && !info.frame.reference->system.empty()
                        ? info.frame.reference->system
                        : kPlaneWkt;
}

} // namespace

bool isTriangulation(const std::filesystem::path& file)
{
    return foundation::inSmallLetters(file.extension().string()) == ".mt";
}

foundation::Result<Raster> readTriangulation(const std::filesystem::path& file, GdalSession& gdal)
{
    const auto opened = mt::MtFile::open(file);
    if (!opened) return opened.error();
    auto sampled = mt::sampleSurface(*opened, kMostSampledSide);
    if (!sampled) return sampled.error();
    const mt::MtInfo& info = opened->info();
    Raster raster;
    raster.columns = sampled->columns;
    raster.rows = sampled->rows;
    raster.heightsM = std::move(sampled->heights);
    const double pitchX = sampled->spacingX / info.frame.stepX, pitchY = sampled->spacingY / info.frame.stepY;
    place(raster, info, pitchX, pitchY);
    if (pitchX != 1.0 || pitchY != 1.0)
        gdal.note("is sampled at " + std::to_string(raster.columns) + " x " + std::to_string(raster.rows) +
                  " points; its own points lie between them, too");
    if (std::ranges::count(sampled->isThere, 0) > 0)
    {
        raster.isOutside = std::move(sampled->isThere);
        for (std::uint8_t& sample : raster.isOutside)
            sample = sample == 0;
    }
    return raster;
}

foundation::Result<Raster> readTriangulationHead(const std::filesystem::path& file)
{
    const auto opened = mt::MtFile::open(file);
    if (!opened) return opened.error();
    Raster raster;
    raster.columns = raster.rows = 2;
    place(raster, opened->info(), 1.0, 1.0);
    return raster;
}

} // namespace osgTerrainROAM::core
