// SPDX-License-Identifier: Apache-2.0
// The points of maps stand where they stood the last time, and are stood anew where that was damaged.
#include "scene/MapObjects.h"

#include <limits>

#include <foundation/KeptResults.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "KeptFiles.h"
#include "SyntheticField.h"

namespace
{

using scenery::models::Kind;
using testsupport::filesIn;
using trainer::MapObjects;

constexpr double kGroundM = 412.0;

MapObjects twoOaks()
{
    MapObjects objects;
    objects.models = {{static_cast<std::uint64_t>(Kind::oak), 3}, {static_cast<std::uint64_t>(Kind::bus), 1}};
    objects.objects = {{{1.0, 2.0, 3.0}, 0.5, 1.25, 0}, {{4.0, 5.0, 6.0}, -0.5, 0.75, 1}};
    objects.unused = 7;
    objects.notes = {"a note"};
    return objects;
}

/// A map with an oak, a tree of OpenStreetMap, a castle and the outline of an oak.
void writeMap(const std::filesystem::path& file)
{
    GDALAllRegister();
    GDALDataset* const map =
        GetGDALDriverManager()->GetDriverByName("GPKG")->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
    OGRSpatialReference geodetic;
    geodetic.SetWellKnownGeogCS("WGS84");
    geodetic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* const layer = map->CreateLayer("map", &geodetic, wkbUnknown);
    for (const char* const name : {"kind", "natural", "leaf_type", "heading", "seed", "scale"})
    {
        OGRFieldDefn field(name, OFTString);
        layer->CreateField(&field);
    }
    const auto add = [&](const char* text, std::initializer_list<std::pair<const char*, const char*>> tags)
    {
        OGRFeature feature(layer->GetLayerDefn());
        for (const auto& [key, value] : tags)
            feature.SetField(key, value);
        OGRGeometry* geometry = nullptr;
        EXPECT_EQ(OGRGeometryFactory::createFromWkt(text, nullptr, &geometry), OGRERR_NONE);
        feature.SetGeometryDirectly(geometry);
        EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    };
    add("POINT(8.02 46.02)", {{"kind", "oak"}, {"heading", "90"}, {"seed", "3"}, {"scale", "99"}});
    add("POINT(8.021 46.02)", {{"natural", "tree"}, {"leaf_type", "needleleaved"}});
    add("POINT(8.02 46.021)", {{"kind", "castle"}});
    add("POLYGON((8.02 46.022, 8.021 46.022, 8.021 46.023, 8.02 46.022))", {{"kind", "oak"}});
    GDALClose(map);
}

} // namespace

TEST(MapObjects, StandWhereTheyStoodTheLastTime)
{
    const testsupport::TestFolder folder("map-objects");
    const testsupport::UserCache cache(folder / "cache");
    const auto file = folder / "map.gpkg", made = folder / "cache/osgTrainer/made";
    writeMap(file);
    const auto kept = foundation::KeptResults::ofUser();
    const osgTerrainROAM::core::RoamTile tile(
        osgTerrainROAM::core::PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65))), &kept);
    const auto read = [&]
    { return trainer::readMapObjects(file, tile, [](glm::dvec2) { return kGroundM; }); };
    const auto first = read();
    ASSERT_TRUE(first);
    ASSERT_EQ(first->objects.size(), 2U);
    EXPECT_EQ(first->unused, 2U); // the castle and the outline
    const std::vector<trainer::MapModel> models{{static_cast<std::uint64_t>(Kind::oak), 3},
                                                {static_cast<std::uint64_t>(Kind::spruce), 1}};
    EXPECT_EQ(first->models, models);
    EXPECT_EQ(first->objects[0].position.z, kGroundM);
    EXPECT_EQ(first->objects[0].headingRad, 0.0); // east
    EXPECT_EQ(first->objects[0].scale, 20.0);     // no larger
    EXPECT_EQ(first->objects[1].scale, 1.0);
    EXPECT_EQ(first->objects[1].model, 1U);
    const auto files = filesIn(made);
    const auto again = read();
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, *first);
    EXPECT_EQ(filesIn(made), files); // found, not made
    testsupport::writeNonsense(made);
    const auto nonsense = filesIn(made);
    const auto anew = read();
    ASSERT_TRUE(anew);
    EXPECT_EQ(*anew, *first);
    EXPECT_NE(filesIn(made), nonsense);
}

TEST(MapObjects, OfOtherBytesAreNone)
{
    const MapObjects objects = twoOaks();
    const std::string bytes = bytesOf(objects);
    ASSERT_EQ(trainer::mapObjectsIn(bytes), objects);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(trainer::mapObjectsIn(bytes.substr(0, size))) << size;
    EXPECT_FALSE(trainer::mapObjectsIn(bytes + "x"));
}

TEST(MapObjects, ThatCannotStandAreNone)
{
    const auto isRefused = [](auto spoil)
    {
        MapObjects objects = twoOaks();
        spoil(objects);
        return !trainer::mapObjectsIn(bytesOf(objects));
    };
    EXPECT_FALSE(isRefused([](MapObjects&) {}));
    EXPECT_TRUE(isRefused([](MapObjects& o) { o.models[1].kind = scenery::models::kinds().size(); }));
    EXPECT_TRUE(isRefused([](MapObjects& o) { o.objects[1].model = 2; }));
    EXPECT_TRUE(isRefused([](MapObjects& o) { o.objects[0].scale = 0.0; }));
    EXPECT_TRUE(
        isRefused([](MapObjects& o) { o.objects[0].scale = std::numeric_limits<double>::quiet_NaN(); }));
    EXPECT_TRUE(
        isRefused([](MapObjects& o) { o.objects[0].position.y = std::numeric_limits<double>::infinity(); }));
}
