// SPDX-License-Identifier: Apache-2.0
#include "PlaceField.h"

#include <cmath>
#include <string>

#include "CellSizeReference.h"
#include "GeodeticLocator.h"
#include "GeodeticNetBuilder.h"
#include "MosaicSource.h"

namespace osgTerrainROAM::core
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

Outcome placeField(HeightField& field, Raster& raster, const DemImportOptions& options, GdalSession& gdal)
{
    if (!raster.frame)
    {
        if (!options.spacingM)
            return Error{field.name, "has no georeference",
                         "state the metres between its samples: spacing = METRES in a .roam file, or "
                         "--spacing METRES"};
        if (!std::isfinite(*options.spacingM) || *options.spacingM <= 0.0)
            return Error{field.name, "cannot have samples " + std::to_string(*options.spacingM) + " m apart",
                         "give --spacing the metres between samples"};
        field.spacingEastM = field.spacingNorthM = *options.spacingM;
        return foundation::success();
    }
    settleReference(raster);
    if (const std::optional<double> metres = metresOfPlane(raster.crsWkt))
    {
        field.spacingEastM = raster.frame->stepX * *metres;
        field.spacingNorthM = raster.frame->stepY * *metres;
        return foundation::success();
    }
    const Result<GeodeticLocator> locator =
        GeodeticLocator::create(field.name, raster, options.verticalDatum, gdal);
    if (!locator) return locator.error();
    return georeference(field, *locator);
}

std::optional<GridPlace> placeOf(const Raster& raster)
{
    if (!raster.frame) return std::nullopt;
    const GridFrame& at = *raster.frame;
    const std::optional<double> metres = metresOfPlane(raster.crsWkt);
    const double unit = metres.value_or(1.0);
    return GridPlace{metres ? std::string() : raster.crsWkt, at.firstX * unit, at.firstY * unit,
                     at.stepX * unit, at.stepY * unit};
}

} // namespace osgTerrainROAM::core
