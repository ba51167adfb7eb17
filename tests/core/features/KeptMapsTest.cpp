// SPDX-License-Identifier: Apache-2.0
// What maps gave is found again, the same, and made anew where it was damaged.
#include <fstream>
#include <memory>

#include <foundation/KeptFrom.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <osgTerrainROAM/core/features/FeatureImport.h>
#include <osgTerrainROAM/core/features/ShapeImport.h>

#include "FeatureBytes.h"
#include "KeptFiles.h"
#include "ShapeBytes.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::filesIn;

PlacedTile tile()
{
    return PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65)));
}

/// A map with a road, a field with a hole, a tree and a path of no known kind.
void writeMap(const std::filesystem::path& file, double eastDeg = 8.02)
{
    GDALAllRegister();
    std::filesystem::remove(file);
    GDALDataset* const map =
        GetGDALDriverManager()->GetDriverByName("GPKG")->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
    OGRSpatialReference geodetic;
    geodetic.SetWellKnownGeogCS("WGS84");
    geodetic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* const layer = map->CreateLayer("map", &geodetic, wkbUnknown);
    OGRFieldDefn kind("kind", OFTString), width("width", OFTReal);
    layer->CreateField(&kind);
    layer->CreateField(&width);
    const std::string x = std::to_string(eastDeg), far = std::to_string(eastDeg + 0.004);
    const std::vector<std::pair<const char*, std::string>> things{
        {"road", "LINESTRING(" + x + " 46.02, " + far + " 46.021)"},
        {"field", "POLYGON((" + x + " 46.022, " + far + " 46.022, " + far + " 46.026, " + x +
                      " 46.022),(8.0225 46.0225, 8.0230 46.0225, 8.0230 46.0227, 8.0225 46.0225))"},
        {"oak", "POINT(" + x + " 46.03)"},
        {"castle", "LINESTRING(" + x + " 46.03, " + far + " 46.03)"}};
    for (const auto& [name, text] : things)
    {
        OGRFeature feature(layer->GetLayerDefn());
        feature.SetField("kind", name);
        feature.SetField("width", 6.5);
        OGRGeometry* geometry = nullptr;
        EXPECT_EQ(OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &geometry), OGRERR_NONE);
        feature.SetGeometryDirectly(geometry);
        EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
    GDALClose(map);
}

struct Kept
{
    testsupport::TestFolder folder{"kept-maps"};
    std::filesystem::path map = folder / "map.gpkg", made = folder / "made";
    foundation::KeptFrom from{std::make_shared<const foundation::KeptResults>(made),
                              foundation::ContentMark().add(std::string_view("hills"))};

    Kept() { writeMap(map); }

    std::string features() const
    {
        const auto set = importFeatures(map, tile(), from);
        return set ? bytesOf(*set) : set.error().message();
    }
    std::string shapes() const
    {
        const auto set = importShapes(map, tile(), from);
        return set ? bytesOf(*set) : set.error().message();
    }
};

TEST(KeptMaps, GiveWhatReadingThemGave)
{
    const Kept kept;
    const auto read = importFeatures(kept.map, tile());
    const auto shapes = importShapes(kept.map, tile());
    ASSERT_TRUE(read && shapes);
    EXPECT_EQ(read->report.taken, 2U);
    EXPECT_EQ(shapes->shapes.size(), 2U);
    EXPECT_EQ(shapes->linear.size(), 2U);
    for (int i = 0; i < 2; ++i)
    {
        const auto again = importFeatures(kept.map, tile(), kept.from);
        ASSERT_TRUE(again);
        EXPECT_EQ(again->report.message(), read->report.message());
        ASSERT_EQ(again->features.size(), read->features.size());
        for (std::size_t k = 0; k < read->features.size(); ++k)
        {
            EXPECT_EQ(again->features[k].style, read->features[k].style);
            EXPECT_EQ(again->features[k].isArea, read->features[k].isArea);
            EXPECT_EQ(again->features[k].paths, read->features[k].paths);
        }
        const auto found = importShapes(kept.map, tile(), kept.from);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->lines, shapes->lines);
        for (std::size_t k = 0; k < shapes->shapes.size(); ++k)
        {
            EXPECT_EQ(found->shapes[k].id, shapes->shapes[k].id);
            EXPECT_EQ(found->shapes[k].point, shapes->shapes[k].point);
            EXPECT_EQ(found->shapes[k].rings, shapes->shapes[k].rings);
            EXPECT_EQ(found->shapes[k].tags, shapes->shapes[k].tags);
        }
        EXPECT_EQ(found->linear[1].points, shapes->linear[1].points);
        EXPECT_EQ(filesIn(kept.made).size(), 2U);
    }
}

TEST(KeptMaps, TellWhatGdalWarnedOfAgain)
{
    const Kept kept;
    EXPECT_TRUE(importShapes(kept.map, tile())->notes.empty());
    {
        std::fstream file(kept.map, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(68); // the application's id of SQLite's header
        file.write("abcd", 4);
    }
    for (int i = 0; i < 2; ++i)
    {
        const auto features = importFeatures(kept.map, tile(), kept.from);
        const auto shapes = importShapes(kept.map, tile(), kept.from);
        ASSERT_TRUE(features && shapes);
        for (const auto& notes : {features->report.notes, shapes->notes})
        {
            ASSERT_EQ(notes.size(), 1U);
            EXPECT_TRUE(notes[0].starts_with(kept.map.string() + ": GDAL warns: ")) << notes[0];
        }
    }
}

TEST(KeptMaps, AreReadOnceAndAnewWhereTheyChanged)
{
    const Kept kept;
    const std::string features = kept.features(), shapes = kept.shapes();
    const auto files = filesIn(kept.made);
    EXPECT_EQ(kept.features(), features);
    EXPECT_EQ(kept.shapes(), shapes);
    EXPECT_EQ(filesIn(kept.made), files);
    writeMap(kept.map, 8.021);
    EXPECT_NE(kept.features(), features);
    EXPECT_EQ(filesIn(kept.made).size(), 3U);
    std::filesystem::copy_file(kept.map, kept.folder / "sole.gpkg");
    std::ofstream(kept.folder / "sole.gpkg.aux.xml") << "<PAMDataset/>";
    ASSERT_TRUE(importShapes(kept.folder / "sole.gpkg", tile(), kept.from));
    EXPECT_EQ(filesIn(kept.made).size(), 3U); // it may follow from what lies beside it
}

TEST(KeptMaps, DamagedOnesAreReadAnew)
{
    const Kept kept;
    const std::string features = kept.features(), shapes = kept.shapes();
    testsupport::writeNonsense(kept.made);
    const auto nonsense = filesIn(kept.made);
    EXPECT_EQ(kept.features(), features);
    EXPECT_EQ(kept.shapes(), shapes);
    for (const auto& [name, number] : filesIn(kept.made))
        EXPECT_NE(nonsense.at(name), number) << name;
}

TEST(KeptMaps, CutBytesAreNone)
{
    const Kept kept;
    const std::string features = kept.features(), shapes = kept.shapes();
    ASSERT_TRUE(featuresIn(features) && shapesIn(shapes));
    for (std::size_t size = 0; size < features.size(); ++size)
        EXPECT_FALSE(featuresIn(features.substr(0, size))) << size;
    for (std::size_t size = 0; size < shapes.size(); ++size)
        EXPECT_FALSE(shapesIn(shapes.substr(0, size))) << size;
    EXPECT_FALSE(featuresIn(features + "x"));
    EXPECT_FALSE(shapesIn(shapes + "x"));
}

TEST(KeptMaps, StylesThatAreNotAreNone)
{
    FeatureSet set;
    set.features.emplace_back().style.kind = static_cast<FeatureKind>(17);
    EXPECT_FALSE(featuresIn(bytesOf(set)));
    set.features.back().style.kind = FeatureKind::river;
    EXPECT_TRUE(featuresIn(bytesOf(set)));
    set.features.back().style.crop = static_cast<Crop>(-1);
    EXPECT_FALSE(featuresIn(bytesOf(set)));
}

} // namespace
