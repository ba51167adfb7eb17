// SPDX-License-Identifier: Apache-2.0
// Terrains joined from real data, on flights along their seams.
#include <array>
#include <cmath>
#include <numeric>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "RasterWriter.h"
#include "RealData.h"
#include "SoundMesh.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::isSoundFrom;

/// Every `every`-th sample of a part of a field that is 3" apart, as a raster of its own.
void writePart(const HeightField& field, const std::filesystem::path& file, const GridRect& part, int every)
{
    RasterSpec spec;
    spec.columns = (part.east - part.west) / every + 1;
    spec.rows = (part.north - part.south) / every + 1;
    spec.epsg = 4326;
    const double step = every / 1200.0;
    spec.geoTransform = {-72.0 + part.west / 1200.0 - 0.5 * step, step, 0.0,
                         44.0 + part.south / 1200.0 - 0.5 * step, 0.0,  step};
    for (int row = 0; row < spec.rows; ++row)
        for (int column = 0; column < spec.columns; ++column)
            spec.values.push_back(field.heightM(part.west + column * every, part.south + row * every));
    writeRaster(file, "GTiff", spec);
}

/// A terrain, and a column of its grid that is a seam from south to north.
struct Joined
{
    std::shared_ptr<const RoamTile> tile;
    std::vector<int> seams;
};

/// 150 m over the seam, looking along it.
std::vector<viewlod::ViewState> flightAlong(const PlacedTile& tile, int column, int frames)
{
    std::vector<viewlod::ViewState> views;
    const auto groundOf = [&](double row)
    {
        const glm::dvec3 p = tile.frame().positionAt(column, row, 0.0);
        return groundAt(tile, p.x, p.y)->position;
    };
    for (int i = 0; i < frames; ++i)
    {
        const double row = (tile.grid().dataRows() - 60.0) * (i + 0.5) / frames;
        const glm::dvec3 eye = groundOf(row) + glm::dvec3(0.0, 0.0, 150.0);
        views.push_back(
            viewlod::ViewState::fromMatrices(glm::lookAt(eye, groundOf(row + 40.0), {0.0, 0.0, 1.0}),
                                             glm::perspective(0.8, 1.6, 1.0, 2e5), 1280, 800));
    }
    return views;
}

void expectSound(const Joined& joined, double tolerancePx)
{
    RoamMesh mesh{SplitBounds(joined.tile)};
    for (const int seam : joined.seams)
        for (const viewlod::ViewState& view : flightAlong(joined.tile->tile, seam, 3))
        {
            ASSERT_TRUE(isSoundFrom(mesh, view, tolerancePx));
        }
}

/// The mean over rows of the change of slope across a column.
double bendM(const HeightField& field, int column)
{
    double sum = 0.0;
    for (int row = 0; row < field.rows; ++row)
        sum += std::abs(field.heightM(column + 1, row) - 2.0 * field.heightM(column, row) +
                        field.heightM(column - 1, row));
    return sum / field.rows;
}

TEST(SeamFlight, OverTwoTilesThatShareAColumn)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    const std::vector<std::filesystem::path> files{folder / "N49W124.tif", folder / "N49W123.tif"};
    const auto field = importDems(files);
    ASSERT_TRUE(field) << field.error().message();
    EXPECT_EQ(field->columns, 2401);
    EXPECT_EQ(field->mosaic.bentSamples, 0u);
    EXPECT_EQ(field->mosaic.largestStepM, 0.0);
    // The slope changes no more at the seam than at any column near it.
    double around = 0.0;
    for (int column = 1150; column < 1250; ++column)
        around = std::max(around, bendM(*field, column));
    EXPECT_LE(bendM(*field, 1200), around);
    expectSound({std::make_shared<const RoamTile>(PlacedTile(*field)), {1200}}, 1.0);
}

TEST(SeamFlight, OverThreeResolutions)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "dem/N44W072.hgt");
    const auto whole = importDem(file);
    ASSERT_TRUE(whole);
    const TemporaryFolder folder;
    const std::vector<std::filesystem::path> files{folder / "coarse.tif", folder / "middle.tif",
                                                   folder / "fine.tif"};
    writePart(*whole, files[0], {800, 0, 1200, 1200}, 4);
    writePart(*whole, files[1], {400, 0, 800, 1200}, 2);
    writePart(*whole, files[2], {0, 0, 400, 1200}, 1);
    const auto field = importDems(files);
    ASSERT_TRUE(field) << field.error().message();
    ASSERT_EQ(field->columns, 1201);
    for (int row = 0; row <= 1200; row += 7)
        for (int column = 0; column <= 400; column += 7)
            ASSERT_EQ(field->heightM(column, row), whole->heightM(column, row));
    // The slope changes hardly more at the seam than inside the finer side. Without bending it would: the
    // comparison takes the coarse raster as it is interpolated far from finer data.
    const auto limit = [&](int seam)
    {
        double most = 0.0;
        for (int column = seam - 120; column <= seam - 20; ++column)
            most = std::max(most, bendM(*field, column));
        return 1.4 * most;
    };
    for (const int seam : {400, 800})
        EXPECT_LE(bendM(*field, seam), limit(seam)) << seam;
    writePart(*whole, files[2], {0, 0, 10, 1200}, 1);
    const auto apart = importDems(std::vector{files[0], files[2]});
    ASSERT_EQ(apart->columns, 1201);
    HeightField unbent = *field;
    for (int row = 0; row <= 1200; ++row)
        unbent.heightsM[static_cast<std::size_t>(row) * 1201 + 801] = apart->heightM(801, row);
    EXPECT_GT(bendM(unbent, 800), limit(800));
    expectSound({std::make_shared<const RoamTile>(PlacedTile(*field)), {400, 800}}, 1.0);
}

} // namespace
