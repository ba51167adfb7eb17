// SPDX-License-Identifier: Apache-2.0
#include "material/ImageryDrape.h"

#include <cmath>

#include <gtest/gtest.h>

#include <osg/Notify>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterWriter.h"
#include "SetScaleY.h"
#include "SyntheticField.h"
#include "UnsortedTags.h"

namespace
{

using namespace osgTerrainROAM;

constexpr int kDrapeColumns = 41;
constexpr int kDrapeRows = 31;

/// A raster of 3" cells whose south-western sample is 46° N 8° E.
core::PlacedTile geographicTile(const TemporaryFolder& folder)
{
    RasterSpec spec;
    spec.columns = kDrapeColumns;
    spec.rows = kDrapeRows;
    spec.geoTransform = northUp3Seconds(kDrapeRows);
    spec.epsg = 4326;
    writeRaster(folder / "dem.tif", "GTiff", spec);
    auto field = core::importDem(folder / "dem.tif", {});
    EXPECT_TRUE(field) << field.error().message();
    return core::PlacedTile(std::move(*field));
}

/// Imagery in UTM 32N over the tile's western half: by 2 a pixel brighter to the east, by 2.5 to the north.
void writeImagery(const std::filesystem::path& file, double eastM, double northM)
{
    RasterSpec spec;
    spec.columns = 60;
    spec.rows = 50;
    spec.bands = 3;
    spec.type = GDT_Byte;
    spec.epsg = 32632;
    spec.geoTransform = std::array<double, 6>{eastM, 30.0, 0.0, northM + 50 * 30.0, 0.0, -30.0};
    for (int row = 0; row < 50; ++row)
        for (int column = 0; column < 60; ++column)
            spec.values.push_back(std::floor(column * 2.0 + (49 - row) * 2.5));
    writeRaster(file, "GTiff", spec);
}

const unsigned char* texelAt(const osg::Image& image, double columnShare, double rowShare)
{
    return image.data(static_cast<int>(std::lround(columnShare * (image.s() - 1))),
                      static_cast<int>(std::lround(rowShare * (image.t() - 1))));
}

} // namespace

TEST(ImageryDrape, ReprojectsToTheDataGrid)
{
    const TemporaryFolder folder;
    const auto tile = geographicTile(folder);
    // 46° N 8° E lies at 422 567.8 E 5 094 533.6 N in zone 32.
    writeImagery(folder / "image.tif", 422567.8 - 300.0, 5094533.6 - 300.0);
    const auto drape = imageryDrape(folder / "image.tif", tile);
    ASSERT_TRUE(drape) << drape.error().message();
    // The south-western sample is 300 m in from both edges: pixel 10 of 30 m from each.
    const unsigned char* corner = texelAt(**drape, 0.0, 0.0);
    EXPECT_NEAR(corner[0], 9.5 * 2.0 + 9.5 * 2.5 - 0.5, 2);
    EXPECT_EQ(corner[0], corner[2]);
    EXPECT_EQ(corner[3], 255);
    // 41 columns of 3" are 2.58 km, imagery ends after 1.5 km.
    EXPECT_EQ(texelAt(**drape, 1.0, 0.2)[3], 0) << "beyond the imagery";
    const unsigned char* east = texelAt(**drape, 0.4, 0.0);
    EXPECT_NEAR(east[0] - corner[0], 0.4 * 40 * 64.5 / 30.0 * 2.0, 4)
        << "3 seconds of longitude are 64.5 m there";
    const unsigned char* north = texelAt(**drape, 0.0, 0.4);
    EXPECT_NEAR(north[0] - corner[0], 0.4 * 30 * 92.6 / 30.0 * 2.5, 4);
}

TEST(ImageryDrape, ALayerReachesAsFarAsItsImageryAndKeepsItsResolution)
{
    const TemporaryFolder folder;
    const auto tile = geographicTile(folder);
    // 1800 by 1500 m from 500 m east and 400 m north of the south-western sample: inside the tile of 2.58 by
    // 2.78 km.
    writeImagery(folder / "fine.tif", 422567.8 + 500.0, 5094533.6 + 400.0);
    const auto layer = imageryLayer(folder / "fine.tif", tile);
    ASSERT_TRUE(layer) << layer.error().message();
    EXPECT_NEAR(layer->firstGrid.x, 500.0 / 64.5, 0.4);
    EXPECT_NEAR(layer->firstGrid.y, 400.0 / 92.6, 0.4);
    EXPECT_NEAR(layer->lastGrid.x, 2300.0 / 64.5, 0.8);
    EXPECT_NEAR(layer->lastGrid.y, 1900.0 / 92.6, 0.8);
    EXPECT_NEAR(layer->image->s(), 60, 3);
    EXPECT_NEAR(layer->texelM, 30.0, 1.0);
    // The imagery's middle: column 30 from the west, row 25 from the north.
    EXPECT_NEAR(texelAt(*layer->image, 0.5, 0.5)[0], 29.5 * 2.0 + 24.5 * 2.5, 4);
    writeImagery(folder / "far.tif", 300000.0, 4000000.0);
    EXPECT_FALSE(imageryLayer(folder / "far.tif", tile));
}

TEST(ImageryDrape, RowsFromSouthToNorthLieWhereTheyBelong)
{
    const TemporaryFolder folder;
    const auto tile = geographicTile(folder);
    const double eastM = 422567.8 - 300.0, northM = 5094533.6 - 300.0;
    writeImagery(folder / "image.tif", eastM, northM);
    const auto north = imageryDrape(folder / "image.tif", tile);
    // The same pixels with a negative scale lie upside down.
    testsupport::setScaleY(folder / "image.tif", -30.0, northM);
    const auto south = imageryDrape(folder / "image.tif", tile);
    ASSERT_TRUE(north && south);
    const double low = texelAt(**north, 0.2, 0.1)[0], high = texelAt(**north, 0.2, 0.4)[0];
    EXPECT_NEAR(high - low, 0.3 * 30 * 92.6 / 30.0 * 2.5, 6);
    EXPECT_NEAR(texelAt(**south, 0.2, 0.1)[0] - texelAt(**south, 0.2, 0.4)[0], high - low, 6);
}

namespace
{

/// Keeps what OSG is told while it lives.
class Told : public osg::NotifyHandler
{
public:
    explicit Told(std::string& text) : _text(text) {}
    void notify(osg::NotifySeverity, const char* message) override { _text += message; }

private:
    std::string& _text;
};

} // namespace

TEST(ImageryDrape, WhatGdalWarnsOfIsTold)
{
    const TemporaryFolder folder;
    const auto tile = geographicTile(folder);
    writeImagery(folder / "image.tif", 422567.8 - 300.0, 5094533.6 - 300.0);
    std::string told;
    const osg::ref_ptr<osg::NotifyHandler> former = osg::getNotifyHandler();
    osg::setNotifyHandler(new Told(told));
    const auto plain = imageryDrape(folder / "image.tif", tile);
    const std::string toldOfPlain = told;
    testsupport::unsortTags(folder / "image.tif");
    const auto warned = imageryDrape(folder / "image.tif", tile);
    osg::setNotifyHandler(former);
    ASSERT_TRUE(plain && warned);
    EXPECT_EQ(toldOfPlain, "");
    EXPECT_NE(told.find("image.tif: GDAL warns: "), std::string::npos) << told;
}

TEST(ImageryDrape, WithoutAGeoreferenceIsStretched)
{
    const TemporaryFolder folder;
    RasterSpec spec;
    spec.columns = 16;
    spec.rows = 8;
    spec.type = GDT_Byte;
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 16; ++column)
            spec.values.push_back(10.0 * column + row);
    writeRaster(folder / "plain.png", "PNG", spec);
    const core::PlacedTile tile(testsupport::hills(33, 17), core::Placement::planar);
    const auto drape = imageryDrape(folder / "plain.png", tile);
    ASSERT_TRUE(drape) << drape.error().message();
    EXPECT_NEAR(texelAt(**drape, 0.0, 0.0)[0], 7, 1) << "south-west is the file's last row";
    EXPECT_NEAR(texelAt(**drape, 1.0, 1.0)[0], 150, 1);
    EXPECT_EQ(texelAt(**drape, 0.5, 0.5)[0], texelAt(**drape, 0.5, 0.5)[2]) << "one band is grey";
}

TEST(ImageryDrape, SaysWhatIsWrong)
{
    const TemporaryFolder folder;
    const auto tile = geographicTile(folder);
    const auto missing = imageryDrape(folder / "none.tif", tile);
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message().find("none.tif"), std::string::npos);

    writeImagery(folder / "far.tif", 300000.0, 4000000.0);
    const auto elsewhere = imageryDrape(folder / "far.tif", tile);
    ASSERT_FALSE(elsewhere);
    EXPECT_NE(elsewhere.error().message().find("covers nothing"), std::string::npos);

    const core::PlacedTile plane(testsupport::hills(9, 9), core::Placement::planar);
    EXPECT_FALSE(imageryDrape(folder / "far.tif", plane)) << "a plane has no place to lay a map by";
}
