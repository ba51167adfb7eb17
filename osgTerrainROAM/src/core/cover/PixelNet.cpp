// SPDX-License-Identifier: Apache-2.0
#include "PixelNet.h"

#include <algorithm>
#include <memory>

#include <gdal_priv.h>
#include <ogr_spatialref.h>

namespace osgTerrainROAM::core
{

using foundation::Error;
using foundation::Result;

Result<PixelNet> PixelNet::make(GDALDataset& dataset, const PlacedTile& tile, const std::string& name)
{
    PixelNet net;
    double transform[6];
    const OGRSpatialReference* reference = dataset.GetSpatialRef();
    if (dataset.GetGeoTransform(transform) != CE_None || !reference)
    {
        if (dataset.GetGCPCount() > 0)
            return Error{name, "is placed by control points, not as a grid", "straighten it with gdalwarp"};
        net.stretch(dataset, tile);
        return net;
    }
    if (!tile.field().net)
        return Error{name, "the elevation data have no georeference to lay this imagery by",
                     "use an elevation raster with one, or an imagery without"};
    double inverse[6];
    OGRSpatialReference geodetic;
    geodetic.SetWellKnownGeogCS("WGS84");
    geodetic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRSpatialReference> own(reference->Clone());
    own->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> toImagery(
        OGRCreateCoordinateTransformation(&geodetic, own.get()));
    if (!toImagery || !GDALInvGeoTransform(transform, inverse))
        return Error{name, "its coordinate system cannot be related to the terrain's",
                     "reproject the imagery"};
    const GeodeticNet& nodes = *tile.field().net;
    net._step = nodes.step << tile.grid().exponent(); // nodes count samples of the raster
    net._side = nodes.nodesPerSide;
    for (const GeodeticNet::Node& node : nodes.nodes)
    {
        double x = node.longitudeDeg;
        double y = node.latitudeDeg;
        glm::dvec2 pixel(-1e9);
        if (toImagery->Transform(1, &x, &y))
            pixel = {inverse[0] + inverse[1] * x + inverse[2] * y,
                     inverse[3] + inverse[4] * x + inverse[5] * y};
        net._pixels.push_back(pixel);
    }
    return net;
}

glm::dvec2 PixelNet::pixelAt(double column, double row) const
{
    const double a = column / _step;
    const double b = row / _step;
    const int i = std::clamp(static_cast<int>(a), 0, _side - 2);
    const int j = std::clamp(static_cast<int>(b), 0, _side - 2);
    const auto at = [&](int x, int y) { return _pixels[static_cast<std::size_t>(y) * _side + x]; };
    return glm::mix(glm::mix(at(i, j), at(i + 1, j), a - i), glm::mix(at(i, j + 1), at(i + 1, j + 1), a - i),
                    b - j);
}

void PixelNet::stretch(GDALDataset& dataset, const PlacedTile& tile)
{
    _step = tile.grid().side() - 1;
    _side = 2;
    const double scaleX = static_cast<double>(dataset.GetRasterXSize()) / (tile.grid().dataColumns() - 1);
    const double scaleY = static_cast<double>(dataset.GetRasterYSize()) / (tile.grid().dataRows() - 1);
    const double height = dataset.GetRasterYSize();
    for (const double row : {0.0, static_cast<double>(_step)})
        for (const double column : {0.0, static_cast<double>(_step)})
            _pixels.emplace_back(column * scaleX, height - row * scaleY);
}

} // namespace osgTerrainROAM::core
