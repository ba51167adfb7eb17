// SPDX-License-Identifier: Apache-2.0
#include "SyntheticScene.h"

#include <cmath>

#include <gtest/gtest.h>

#include "SyntheticField.h"

namespace syntheticscene
{

using namespace osgTerrainROAM;

namespace
{

constexpr int kColumns = 200;
constexpr int kRows = 180;
constexpr double kSpacingM = 25.0;

/// A bump of the given radius with a smooth foot.
double bump(double column, double row, double atColumn, double atRow, double radius)
{
    const double x = (column - atColumn) / radius;
    const double y = (row - atRow) / radius;
    const double inside = 1.0 - x * x - y * y;
    return inside > 0.0 ? inside * inside : 0.0;
}

osg::Vec3d toOsg(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

} // namespace

core::HeightField islandField()
{
    core::HeightField field;
    field.name = "island";
    field.columns = kColumns;
    field.rows = kRows;
    field.spacingEastM = field.spacingNorthM = kSpacingM;
    testsupport::Random random(77);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column)
        {
            double height = -25.0 + 120.0 * bump(column, row, 95, 90, 95) +
                            1000.0 * bump(column, row, 130, 120, 62) +
                            450.0 * bump(column, row, 60, 115, 45) + 220.0 * bump(column, row, 80, 50, 42);
            height += 0.05 * std::max(height, 0.0) * (random.unit() - 0.5);
            if (std::hypot(column - 95.0, row - 85.0) < 8.0) height = 70.0;
            field.heightsM.push_back(static_cast<float>(std::floor(std::max(height, 0.0) * 16.0) / 16.0));
        }
    return field;
}

std::shared_ptr<const core::RoamTile> islandTile()
{
    return testsupport::planarTile(islandField());
}

std::vector<Viewpoint> viewpoints(const core::PlacedTile& tile)
{
    const osg::Vec3d beach = toOsg(tile.position(60, 40));
    const osg::Vec3d peak = toOsg(tile.position(130, 120));
    const osg::Vec3d hills = toOsg(tile.position(70, 60));
    return {{"driver", beach + osg::Vec3d(0, 0, 1.5), peak},
            {"pilot", hills + osg::Vec3d(0, 0, 300), peak + osg::Vec3d(-300, 0, -400)},
            {"high", osg::Vec3d(1500, -2500, 3000), osg::Vec3d(2500, 2200, 0)}};
}

namespace
{

template<class Tile>
osg::ref_ptr<RoamTerrain> withMaterial(const std::shared_ptr<Tile>& tile, double tolerancePx)
{
    core::LandParameters land;
    land.treeLineM = 550.0;
    land.snowLineM = 800.0;
    const osg::ref_ptr<TerrainMaterial> material =
        new TerrainMaterial(tile->tile, climateOf(tile->tile, land));
    osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material);
    EXPECT_TRUE(terrain->drawable()->setErrorTolerancePx(tolerancePx));
    osgSky::AtmosphereSettings settings;
    settings.sunDirectionWorld = osgSky::sunDirectionFromAngles(235.0, 40.0);
    settings.visibilityM = 30000.0;
    terrain->setAtmosphere(new osgSky::Atmosphere(settings));
    return terrain;
}

} // namespace

osg::ref_ptr<RoamTerrain> dressed(const std::shared_ptr<core::RoamTile>& tile, double tolerancePx)
{
    return withMaterial(tile, tolerancePx);
}

osg::ref_ptr<RoamTerrain> islandTerrain(double tolerancePx)
{
    return withMaterial(islandTile(), tolerancePx);
}

osg::ref_ptr<RoamTerrain> editableIsland()
{
    return dressed(std::make_shared<core::RoamTile>(core::PlacedTile(
                       islandField(), {.placement = core::Placement::planar, .gridExponent = 5})),
                   1.0);
}

std::unique_ptr<osgOffscreen::OffscreenViewer> viewerOn(osg::Node* node, osgOffscreen::Backend backend)
{
    osgOffscreen::OffscreenSettings settings;
    settings.backend = backend;
    settings.widthPx = 320;
    settings.heightPx = 180;
    auto made = osgOffscreen::OffscreenViewer::create(settings);
    if (!made)
    {
        ADD_FAILURE() << made.error().message();
        return nullptr;
    }
    auto viewer = std::move(*made);
    viewer->viewer().setSceneData(node);
    viewer->camera().setClearColor(osg::Vec4(0.75f, 0.81f, 0.86f, 1.0f));
    viewer->camera().setProjectionMatrixAsPerspective(45.0, 320.0 / 180.0, 0.5, 30000.0);
    return viewer;
}

void look(osgOffscreen::OffscreenViewer& viewer, const Viewpoint& from)
{
    viewer.camera().setViewMatrixAsLookAt(from.eye, from.target, osg::Vec3d(0, 0, 1));
}

} // namespace syntheticscene
