// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <osgTerrainROAM/core/features/FeatureImport.h>
#include <osgTerrainROAM/core/features/ShapeImport.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "FeatureText.h"

namespace
{

using namespace osgTerrainROAM::core;
using namespace featuretext;
using testing::HasSubstr;

std::string messageOf(const std::filesystem::path& source, const PlacedTile& tile)
{
    const auto set = importFeatures(source, tile);
    return set ? "" : set.error().message();
}

/// A GeoPackage with one line in UTM zone 32, at the tile's geodetic centre.
std::filesystem::path writeGeoPackage(const Folder& folder, const Geodetic& at, bool withReference)
{
    GDALAllRegister();
    const auto path = folder.path() / "map.gpkg";
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    GDALDataset* dataset = driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
    OGRSpatialReference utm, geodetic;
    utm.SetWellKnownGeogCS("WGS84");
    utm.SetUTM(32);
    geodetic.SetWellKnownGeogCS("WGS84");
    geodetic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    double x = at.longitudeDeg, y = at.latitudeDeg;
    const std::unique_ptr<OGRCoordinateTransformation> transformation(
        OGRCreateCoordinateTransformation(&geodetic, &utm));
    EXPECT_TRUE(transformation->Transform(1, &x, &y));
    OGRLayer* layer = dataset->CreateLayer("roads", withReference ? &utm : nullptr, wkbLineString);
    OGRFeature feature(layer->GetLayerDefn());
    OGRLineString line;
    line.addPoint(x, y);
    line.addPoint(x + 400.0, y);
    feature.SetGeometry(&line);
    EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    GDALClose(dataset);
    return path;
}

} // namespace

TEST(FeatureImport, PlanarTilesTakeCoordinatesAsMetres)
{
    const Folder folder("features-planar");
    const auto path =
        folder.write("map.geojson",
                     collection({lineFeature(R"("highway":"primary","width":"9")", {{100, 200}, {400, 250}}),
                                 areaFeature(R"("kind":"field")", {{0, 0}, {90, 0}, {90, 80}})}));
    const auto set = importFeatures(path, planarTile());
    ASSERT_TRUE(set) << set.error().message();
    ASSERT_EQ(set->features.size(), 2u);
    EXPECT_EQ(set->features[0].style.widthM, 9.0);
    EXPECT_EQ(set->features[0].paths[0][1], glm::dvec2(400, 250));
    EXPECT_TRUE(set->features[1].isArea);
    EXPECT_EQ(set->features[1].paths[0].size(), 3u) << "rings are not closed";
}

TEST(FeatureImport, CurvedTilesPutAPlaceWhereItsGroundIs)
{
    const auto tile = curvedTile();
    const Folder folder("features-curved");
    const auto path = folder.write(
        "map.geojson", collection({lineFeature(R"("kind":"road")", {{8.011, 46.009}, {8.012, 46.009}})}));
    const auto set = importFeatures(path, tile);
    ASSERT_TRUE(set) << set.error().message();
    const glm::dvec2 place = set->features[0].paths[0][0];
    const auto ground = groundAt(tile, place.x, place.y);
    ASSERT_TRUE(ground);
    const Geodetic there = tile.frame().geodeticFromLocal(ground->position);
    EXPECT_NEAR(there.latitudeDeg, 46.009, 2e-8);
    EXPECT_NEAR(there.longitudeDeg, 8.011, 2e-8);
}

TEST(FeatureImport, FarFromTheOriginTheEllipsoidIsNotTheGround)
{
    // Mutation of the test above: 60 km away, the position without its height is metres off.
    auto field = testsupport::onTheEarth(testsupport::hills(65, 65));
    const PlacedTile tile(std::move(field), Geodetic{46.0, 7.2, 0.0});
    const Folder folder("features-far");
    const auto path = folder.write(
        "map.geojson", collection({lineFeature(R"("kind":"road")", {{8.011, 46.009}, {8.012, 46.009}})}));
    const auto set = importFeatures(path, tile);
    ASSERT_TRUE(set);
    const glm::dvec2 flat(tile.frame().localFromGeodetic({46.009, 8.011, 0.0}));
    EXPECT_GT(glm::distance(set->features[0].paths[0][0], flat), 2.0);
    const auto ground = groundAt(tile, set->features[0].paths[0][0].x, set->features[0].paths[0][0].y);
    ASSERT_TRUE(ground);
    EXPECT_NEAR(tile.frame().geodeticFromLocal(ground->position).longitudeDeg, 8.011, 1e-6);
}

TEST(FeatureImport, AGeoPackageIsReprojected)
{
    const auto tile = curvedTile();
    const Folder folder("features-gpkg");
    const Geodetic at{46.02, 8.02, 0.0};
    const auto set = importFeatures(writeGeoPackage(folder, at, true), tile);
    ASSERT_TRUE(set) << set.error().message();
    ASSERT_EQ(set->features.size(), 1u);
    const auto& path = set->features[0].paths[0];
    EXPECT_GE(path.size(), 3u) << "pieces of 250 m at most";
    const auto ground = groundAt(tile, path[0].x, path[0].y);
    ASSERT_TRUE(ground);
    EXPECT_NEAR(tile.frame().geodeticFromLocal(ground->position).latitudeDeg, at.latitudeDeg, 1e-7);
}

TEST(FeatureImport, NothingIsLostWithoutBeingCounted)
{
    const Folder folder("features-count");
    const auto path = folder.write(
        "map.geojson",
        collection(
            {lineFeature(R"("kind":"road")", {{100, 200}, {400, 250}}),
             lineFeature(R"("highway":"steps")", {{100, 200}, {400, 250}}),
             lineFeature(R"("highway":"steps")", {{100, 300}, {400, 250}}),
             lineFeature(R"("kind":"road")", {{90000, 200}, {90100, 250}}),
             lineFeature(R"("kind":"road")", {{100, 200}, {100, 200}}),
             areaFeature(R"("kind":"field")", {{0, 0}, {90, 0}}),
             R"({"type":"Feature","properties":{"kind":"road"},"geometry":null})",
             R"({"type":"Feature","properties":{"kind":"road"},"geometry":{"type":"Point","coordinates":[1,2]}})"}));
    const auto set = importFeatures(path, planarTile());
    ASSERT_TRUE(set) << set.error().message();
    const FeatureReport& report = set->report;
    EXPECT_EQ(report.read, 8u);
    EXPECT_EQ(report.taken, 1u);
    EXPECT_EQ(report.outside, 1u);
    EXPECT_EQ(report.invalid, 4u);
    EXPECT_EQ(report.unknown.at("highway=steps"), 2u);
    EXPECT_EQ(report.message(), "1 of 8 features painted; 1 outside; 4 invalid; 2 unknown: highway=steps 2");
}

TEST(FeatureImport, ErrorsNameTheFileAndWhatToDo)
{
    const Folder folder("features-errors");
    EXPECT_THAT(messageOf(folder.path() / "none.gpkg", planarTile()), HasSubstr("none.gpkg: no such file"));
    const auto text = folder.write("notes.txt", "no map");
    EXPECT_THAT(messageOf(text, planarTile()), HasSubstr("notes.txt"));
    const auto castles =
        folder.write("castles.geojson", collection({lineFeature(R"("kind":"castle")", {{1, 2}, {3, 4}})}));
    EXPECT_THAT(messageOf(castles, planarTile()),
                HasSubstr("has nothing to paint: 0 of 1 features painted; 1 unknown"));
    const PlacedTile flat(testsupport::onTheEarth(testsupport::hills(33, 33)), Placement::planar);
    EXPECT_THAT(messageOf(castles, flat), HasSubstr("use placement = curved"));
    EXPECT_THAT(messageOf(writeGeoPackage(folder, {46.02, 8.02, 0.0}, false), curvedTile()),
                HasSubstr("map.gpkg: layer 'roads': has no coordinate system"));
}

TEST(ShapeImport, TakesPointsAndOutlinesWithTheirHolesAndTags)
{
    const Folder folder("shapes");
    const auto path = folder.write("map.geojson",
                                   R"({"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"building": "yes", "other_tags": "\"height\"=>\"7\",\"roof:shape\"=>\"flat\""},
  "geometry": {"type": "MultiPolygon", "coordinates": [
   [[[100, 100], [140, 100], [140, 130], [100, 130], [100, 100]], [[110, 110], [120, 110], [120, 120], [110, 110]]],
   [[[200, 100], [240, 100], [240, 130], [200, 100]]]]}},
 {"type": "Feature", "properties": {"kind": "oak"}, "geometry": {"type": "Point", "coordinates": [50, 60]}},
 {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [10, 10]]}},
 {"type": "Feature", "properties": {"kind": "oak"}, "geometry": {"type": "Point", "coordinates": [-9000, 60]}}]})");
    const auto read = importShapes(path, planarTile());
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->shapes.size(), 3u);
    EXPECT_EQ(read->shapes[0].rings.size(), 2u);
    EXPECT_EQ(read->shapes[0].rings[0].size(), 4u);
    EXPECT_EQ(read->shapes[0].tags.at("height"), "7");
    EXPECT_EQ(read->shapes[0].tags.at("roof:shape"), "flat");
    EXPECT_EQ(read->shapes[1].rings.size(), 1u);
    EXPECT_FALSE(read->shapes[2].isArea());
    EXPECT_EQ(read->shapes[2].point, glm::dvec2(50, 60));
    EXPECT_EQ(read->lines, 1u);
    EXPECT_EQ(read->outside, 1u);
    EXPECT_FALSE(importShapes(folder.path() / "none.gpkg", planarTile()));
}
