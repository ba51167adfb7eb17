// SPDX-License-Identifier: Apache-2.0
#include "TileGround.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <GeographicLib/Geocentric.hpp>

#include <osgTerrain/Layer>
#include <osgTerrain/Terrain>

namespace osgTerrainROAM
{

namespace
{

using core::GeodeticNet;
using core::HeightField;

/// Angle between nodes of the net at which the biquadratic through them leaves the Earth by half a
/// millimetre.
constexpr double kNodeRad = 1e-3;

/// Vertices of a small tile on the Earth reach so high; in a plane the units are scaled to fit.
constexpr float kMostOnEarthM = 40000.0f;

osg::Vec3d modelAt(const osgTerrain::Locator& locator, double u, double v, double height)
{
    osg::Vec3d model;
    locator.convertLocalToModel(osg::Vec3d(u, v, height), model);
    return model;
}

/// Places the nodes where the locator puts them, whatever its ellipsoid: their height over WGS84 is stored in
/// the place of the geoid's.
GeodeticNet::Node nodeAt(const osgTerrain::Locator& locator, double u, double v)
{
    const osg::Vec3d p = modelAt(locator, u, v, 0.0);
    GeodeticNet::Node node{};
    GeographicLib::Geocentric::WGS84().Reverse(p.x(), p.y(), p.z(), node.latitudeDeg, node.longitudeDeg,
                                               node.geoidM);
    return node;
}

/// Computes the metres between neighbouring samples in the middle of the tile.
double spacingM(const osgTerrain::Locator& locator, double du, double dv)
{
    return (modelAt(locator, 0.5 + du, 0.5 + dv, 0.0) - modelAt(locator, 0.5, 0.5, 0.0)).length();
}

void placeOnEarth(HeightField& field, const osgTerrain::Locator& locator)
{
    const double perColumn = 1.0 / (field.columns - 1), perRow = 1.0 / (field.rows - 1);
    field.spacingEastM = spacingM(locator, perColumn, 0.0);
    field.spacingNorthM = spacingM(locator, 0.0, perRow);
    // The longitude's angle, not the metres: towards a pole the parallels bend more.
    const double radPerSample = std::max(std::abs(locator.getTransform()(0, 0)) * perColumn,
                                         std::abs(locator.getTransform()(1, 1)) * perRow);
    GeodeticNet net;
    net.step = 1;
    while (2 * net.step <= (field.tileSide() - 1) / 2 && 2 * net.step * radPerSample <= kNodeRad)
        net.step *= 2;
    net.nodesPerSide = (field.tileSide() - 1) / net.step + 1;
    for (int b = 0; b < net.nodesPerSide; ++b)
        for (int a = 0; a < net.nodesPerSide; ++a)
            net.nodes.push_back(nodeAt(locator, a * net.step * perColumn, b * net.step * perRow));
    field.net = std::move(net);
    for (float& height : field.heightsM)
        height = std::clamp(height, -kMostOnEarthM, kMostOnEarthM);
}

/// Whether the unit cube keeps an extent in each direction. Asked of the transformation: on the Earth, a side
/// may begin and end in a pole.
bool hasExtent(const osgTerrain::Locator& locator)
{
    const osg::Matrixd& m = locator.getTransform();
    const auto axis = [&](int i) { return osg::Vec3d(m(i, 0), m(i, 1), m(i, 2)); };
    const double volume = (axis(0) ^ axis(1)) * axis(2);
    return std::isfinite(volume) && volume != 0.0;
}

osg::Matrixd modelFromEastNorthUp(const core::Geodetic& origin)
{
    double x, y, z;
    std::vector<double> r(9); // row by row; its columns are east, north and up
    GeographicLib::Geocentric::WGS84().Forward(origin.latitudeDeg, origin.longitudeDeg, origin.heightM, x, y,
                                               z, r);
    return {r[0], r[3], r[6], 0, r[1], r[4], r[7], 0, r[2], r[5], r[8], 0, x, y, z, 1};
}

/// Local units a model unit: databases in degrees have cells of 0.0001, which the vertices' steps were not
/// made for.
double localPerModel(double cell, double across, double highest)
{
    double scale = 1.0;
    while (cell > 0.0 && cell * scale < 0.05)
        scale *= 2.0;
    while (highest * scale > std::max(30000.0, across * scale)) // what vertices can reach
        scale *= 0.5;
    return scale;
}

/// Scales `field` and gives its matrix and height scale.
void placeInPlane(HeightField& field, const osgTerrain::Locator& locator, TileGround& ground)
{
    const osg::Vec3d origin = modelAt(locator, 0, 0, 0);
    const osg::Vec3d axes[3] = {modelAt(locator, 1, 0, 0) - origin, modelAt(locator, 0, 1, 0) - origin,
                                modelAt(locator, 0, 0, 1) - origin};
    const double east = axes[0].length(), north = axes[1].length(), up = axes[2].length();
    const auto [low, high] = std::minmax_element(field.heightsM.begin(), field.heightsM.end());
    const double cell = std::sqrt(east / (field.columns - 1) * north / (field.rows - 1));
    const double scale =
        localPerModel(cell, std::max(east, north), up * std::max(std::abs(*low), std::abs(*high)));
    field.spacingEastM = scale * east / (field.columns - 1);
    field.spacingNorthM = scale * north / (field.rows - 1);
    for (float& height : field.heightsM)
        height = static_cast<float>(height * up * scale);
    ground.heightScale *= up * scale;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 3; ++i)
            ground.modelFromLocal(axis, i) = axes[axis][i] / (axes[axis].length() * scale);
    ground.modelFromLocal.setTrans(origin);
}

double skirtHeight(const osgTerrain::TerrainTile& tile)
{
    const auto* layer = dynamic_cast<const osgTerrain::HeightFieldLayer*>(tile.getElevationLayer());
    return layer && layer->getHeightField() ? layer->getHeightField()->getSkirtHeight() : 0.0;
}

/// Computes a skirt depth for a neighbour of another level, which has the data at another resolution: twice
/// the change that halving the resolution makes along the border.
double levelErrorM(const core::RoamTile& tile)
{
    const int columns = tile.tile.grid().dataColumns(), rows = tile.tile.grid().dataRows();
    double error = 0.0;
    for (int column = 1; column < columns; column += 2)
        for (const int row : {0, rows - 1})
            error = std::max<double>(error, tile.errorM({column, row}));
    for (int row = 1; row < rows; row += 2)
        for (const int column : {0, columns - 1})
            error = std::max<double>(error, tile.errorM({column, row}));
    return 2.0 * error;
}

} // namespace

const osgTerrain::Locator* masterLocator(const osgTerrain::TerrainTile& tile)
{
    for (const osgTerrain::Layer* layer : {tile.getElevationLayer(), tile.getColorLayer(0)})
        if (layer && layer->getLocator()) return layer->getLocator();
    return tile.getLocator();
}

std::optional<TileGround> tileGround(const osgTerrain::TerrainTile& tile)
{
    TileGround ground;
    ground.locator = masterLocator(tile);
    auto samples = elevationSamples(tile);
    if (!ground.locator || !hasExtent(*ground.locator) || !samples) return std::nullopt;
    ground.heightScale = tile.getTerrain() ? tile.getTerrain()->getVerticalScale() : 1.0;

    HeightField field;
    field.name = tile.getName();
    field.columns = samples->columns;
    field.rows = samples->rows;
    field.heightsM = samples->heights;
    for (float& height : field.heightsM)
        height = static_cast<float>(height * ground.heightScale);
    const bool onEarth = ground.locator->getCoordinateSystemType() == osgTerrain::Locator::GEOCENTRIC;
    if (onEarth)
        placeOnEarth(field, *ground.locator);
    else
        placeInPlane(field, *ground.locator, ground);
    // Exact, so that neighbours have the same heights along their border.
    core::PlacedTile placed(std::move(field), onEarth ? core::Placement::curved : core::Placement::planar,
                            core::Storage::exact);
    if (onEarth) ground.modelFromLocal = modelFromEastNorthUp(placed.frame().origin());
    ground.tile = std::make_shared<const core::RoamTile>(std::move(placed));
    ground.samples = std::make_shared<const ElevationSamples>(std::move(*samples));
    ground.skirtM = std::max(skirtHeight(tile) * std::abs(ground.heightScale), levelErrorM(*ground.tile));
    return ground;
}

} // namespace osgTerrainROAM
