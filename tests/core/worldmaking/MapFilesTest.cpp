// SPDX-License-Identifier: Apache-2.0
// Maps as editors and services keep them: several files, changes, ids below 1, deleted objects, any order.
#include <set>

#include <bzlib.h>
#include <cpl_conv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "MadeMap.h"
#include "TestFolder.h"
#include "worldmaking/map/JoinLand.h"
#include "worldmaking/map/JoinOsm.h"
#include "worldmaking/map/MapSources.h"
#include "worldmaking/map/ReadLand.h"
#include "worldmaking/map/ReadOsm.h"

namespace
{

using namespace worldmaking;
using testing::HasSubstr;
using testsupport::TestFolder;
using Names = std::multiset<std::string>;

/// A map as both readers see it, by the names of its streets and buildings.
struct Joined
{
    Names streets, shapes;
    StreetMap map;
    JoinReport report;
    std::string error;
};

Joined joinedOf(const TestFolder& folder, const std::vector<std::filesystem::path>& given)
{
    Joined joined;
    const auto sources = mapSourcesOf(given);
    if (!sources) return {{}, {}, {}, {}, sources.error().message()};
    const auto file = joinOsm(*sources, folder / "joined.osm.pbf", joined.report);
    if (!file) return {{}, {}, {}, {}, file.error().message()};
    auto streets = readOsm(*file);
    const auto land = readLand(*file);
    if (!streets) return {{}, {}, {}, {}, streets.error().message()};
    if (!land) return {{}, {}, {}, {}, land.error().message()};
    for (const MapWay& way : streets->ways)
        joined.streets.emplace(valueOf(way.tags, "name"));
    for (const LandShape& shape : land->shapes)
        if (shape.form != ShapeForm::point) joined.shapes.emplace(valueOf(shape.tags, "name"));
    joined.map = std::move(*streets);
    return joined;
}

std::string osm(const std::string& objects, const char* more = "")
{
    return std::string("<?xml version='1.0' encoding='UTF-8'?>\n<osm version='0.6' generator='JOSM'") + more +
           ">" + objects + "</osm>\n";
}

std::string node(int id, double east, const char* more = "")
{
    return "<node id='" + std::to_string(id) + "' lat='42.5' lon='" + std::to_string(1.5 + 0.001 * east) +
           "' " + more + "/>";
}

std::string way(int id, std::initializer_list<int> nodes, const std::string& name, const char* more = "",
                const char* tag = "highway", const char* value = "residential")
{
    std::string text = "<way id='" + std::to_string(id) + "' " + more + ">";
    for (const int ref : nodes)
        text += "<nd ref='" + std::to_string(ref) + "'/>";
    return text + "<tag k='" + tag + "' v='" + value + "'/><tag k='name' v='" + name + "'/></way>";
}

void writeZip(const std::filesystem::path& file,
              const std::vector<std::pair<std::string, std::string>>& entries)
{
    void* const zip = CPLCreateZip(file.c_str(), nullptr);
    for (const auto& [name, bytes] : entries)
    {
        CPLCreateFileInZip(zip, name.c_str(), nullptr);
        CPLWriteFileInZip(zip, bytes.data(), static_cast<int>(bytes.size()));
        CPLCloseFileInZip(zip);
    }
    CPLCloseZip(zip);
}

std::string bzip2Of(const std::string& text)
{
    std::string packed(text.size() + 1000, '\0');
    auto size = static_cast<unsigned>(packed.size());
    BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(text.data()),
                             static_cast<unsigned>(text.size()), 9, 0, 0);
    packed.resize(size);
    return packed;
}

const std::string kPlain =
    osm(node(1, 0) + node(2, 1) + node(3, 2) + way(1, {1, 2}, "a") + way(2, {2, 3}, "b"));

TEST(MapFiles, APlainFileIsReadAsItIs)
{
    const TestFolder folder("maps");
    const auto joined = joinedOf(folder, {folder.write("plain.osm", kPlain)});
    EXPECT_EQ(joined.error, "");
    EXPECT_FALSE(joined.report.isJoined);
    EXPECT_FALSE(std::filesystem::exists(folder / "joined.osm.pbf"));
    EXPECT_EQ(joined.streets, (Names{"a", "b"}));
}

TEST(MapFiles, WhatAnEditorDeletedIsNotThereAndWhatItMadeIs)
{
    const TestFolder folder("maps");
    const std::string text =
        osm(node(-1, 0, "action='modify' visible='true'") + node(-2, 1) +
            node(5, 2, "version='3' action='modify'") + node(-7, 3, "action='delete'") +
            way(-3, {-1, -2}, "new", "action='modify' visible='true'") +
            way(-4, {-2, 5}, "deleted", "action='delete'") + way(8, {-2, 5}, "invisible", "visible='false'") +
            way(9, {5, -1}, "old", "version='2'") +
            way(-6, {-1, -2, 5, -1}, "house", "action='modify'", "building", "yes"));
    const auto joined = joinedOf(folder, {folder.write("josm.osm", text)});
    EXPECT_EQ(joined.error, "");
    EXPECT_EQ(joined.streets, (Names{"new", "old"}));
    EXPECT_EQ(joined.shapes, (Names{"house", "new", "old"}));
    EXPECT_EQ(joined.map.missingNodes, 0u);
    EXPECT_EQ(joined.report.deleted, 3u);
    EXPECT_EQ(joined.report.renumbered, 6u); // objects below 1 that are named: 3 nodes, 3 ways
}

TEST(MapFiles, NewObjectsOfTwoFilesAreTwo)
{
    const TestFolder folder("maps");
    const auto a = folder.write("a.osm", osm(node(-1, 0) + node(-2, 1) + way(-3, {-1, -2}, "a")));
    const auto b = folder.write("b.osm", osm(node(-1, 7) + node(-2, 8) + way(-3, {-1, -2}, "b")));
    const auto joined = joinedOf(folder, {a, b});
    EXPECT_EQ(joined.error, "");
    EXPECT_EQ(joined.streets, (Names{"a", "b"}));
    EXPECT_EQ(joined.map.nodes.size(), 4u);
}

TEST(MapFiles, ObjectsMayComeInAnyOrderAndTwice)
{
    const TestFolder folder("maps");
    // As Overpass gives "out body; >; out skel qt;": ways first, nodes twice, those without tags later.
    const std::string text =
        osm("<note>The data</note>" + way(2, {3, 1}, "b") + way(1, {1, 2}, "a") + node(3, 2) +
            "<node id='1' lat='42.5' lon='1.5'><tag k='natural' v='tree'/></node>" + node(2, 1) + node(1, 0));
    const auto joined = joinedOf(folder, {folder.write("overpass.osm", text)});
    EXPECT_EQ(joined.error, "");
    EXPECT_EQ(joined.streets, (Names{"a", "b"}));
    EXPECT_EQ(joined.map.missingNodes, 0u);
    EXPECT_EQ(joined.report.repeated, 1u);
    const auto land = readLand(folder / "joined.osm.pbf");
    ASSERT_TRUE(land);
    EXPECT_EQ(valueOf(land->shapes.front().tags, "natural"), "tree");
}

TEST(MapFiles, NodesMayStandWithinWays)
{
    const TestFolder folder("maps");
    const std::string text = osm("<way id='5'><bounds minlat='42' minlon='1' maxlat='43' maxlon='2'/>"
                                 "<nd ref='1' lat='42.5' lon='1.5'/><nd ref='2' lat='42.5' lon='1.501'/>"
                                 "<tag k='highway' v='residential'/><tag k='name' v='geom'/></way>");
    const auto joined = joinedOf(folder, {folder.write("geom.osm", text)});
    EXPECT_EQ(joined.error, "");
    EXPECT_EQ(joined.streets, (Names{"geom"}));
    EXPECT_EQ(joined.shapes, (Names{"geom"}));
}

TEST(MapFiles, MiddlesOfWaysAndRelationsArePassedOverAndCounted)
{
    const TestFolder folder("maps");
    const std::string middle = "<center lat='42.5' lon='1.5005'/>";
    const std::string whole = node(1, 0) + node(2, 1) + node(3, 2) + way(1, {1, 2}, "a");
    const std::string alone = "<way id='7'>" + middle + "<tag k='building' v='yes'/></way>",
                      refs = "<way id='8'>" + middle +
                             "<nd ref='81'/><nd ref='82'/><tag k='highway' v='path'/></way>",
                      closed = "<way id='9'><center lat='42.5' lon='1.5'></center><nd ref='2'/><nd ref='3'/>"
                               "<tag k='highway' v='service'/><tag k='name' v='b'/></way>",
                      lake = "<relation id='4'>" + middle +
                             "<member type='way' ref='77' role='outer'/>"
                             "<tag k='natural' v='water'/></relation>",
                      bare = "<relation id='5'>" + middle + "<tag k='route' v='bus'/></relation>";
    const std::pair<std::string, std::size_t> texts[] = {{whole + alone, 1},
                                                         {whole + refs, 1},
                                                         {whole + closed, 0},
                                                         {whole + lake, 1},
                                                         {whole + alone + refs + closed + lake + bare, 4}};
    for (const auto& [text, middles] : texts)
    {
        const auto joined = joinedOf(folder, {folder.write("center.osm", osm(text))});
        EXPECT_EQ(joined.error, "");
        EXPECT_EQ(joined.report.middles, middles);
        EXPECT_EQ(joined.streets.count("a"), 1u);
        EXPECT_EQ(joined.streets.count("b"), text.find("'b'") == std::string::npos ? 0u : 1u);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "joined.osm.pbf.part-whole.osm"));
}

TEST(MapFiles, ChangesAreMadeToTheMapAndStandAlone)
{
    const TestFolder folder("maps");
    const auto plain = folder.write("plain.osm", kPlain);
    const auto change = folder.write(
        "edit.osc", "<osmChange version='0.6' generator='iD'><create>" + node(-1, 5) + way(-1, {3, -1}, "c") +
                        "</create><modify>" + way(1, {1, 2}, "renamed", "version='1'") + "</modify><delete>" +
                        "<way id='2' version='1'/></delete></osmChange>");
    EXPECT_EQ(joinedOf(folder, {plain, change}).streets, (Names{"renamed", "c"}));
    EXPECT_EQ(joinedOf(folder, {change, plain}).streets, (Names{"renamed", "c"})) << "whatever the order";
    EXPECT_EQ(joinedOf(folder, {plain, change}).report.deleted, 1u);
    const auto create =
        folder.write("create.osc", "<osmChange version='0.6'><create>" + node(1, 0, "version='1'") +
                                       node(2, 1, "version='1'") + way(1, {1, 2}, "alone", "version='1'") +
                                       "</create></osmChange>");
    EXPECT_EQ(joinedOf(folder, {create}).streets, (Names{"alone"}));
}

TEST(MapFiles, TheHighestVersionCounts)
{
    const TestFolder folder("maps");
    const std::string nodes = node(1, 0, "version='1'") + node(2, 1, "version='1'");
    const auto old = folder.write("old.osm", osm(nodes + way(1, {1, 2}, "old", "version='2'")));
    const auto now = folder.write("now.osm", osm(nodes + way(1, {1, 2}, "now", "version='5'")));
    const auto early =
        folder.write("early.osc", "<osmChange version='0.6'><modify>" +
                                      way(1, {1, 2}, "early", "version='3'") + "</modify></osmChange>");
    EXPECT_EQ(joinedOf(folder, {old, now}).streets, (Names{"now"}));
    EXPECT_EQ(joinedOf(folder, {now, old}).streets, (Names{"now"}));
    EXPECT_EQ(joinedOf(folder, {old, early}).streets, (Names{"early"}));
    EXPECT_EQ(joinedOf(folder, {now, early}).streets, (Names{"now"})) << "a change that the map has already";
    const auto history =
        folder.write("all.osh", osm(nodes + way(1, {1, 2}, "one", "version='1' visible='true'") +
                                    way(1, {}, "gone", "version='2' visible='false'") +
                                    way(2, {1, 2}, "first", "version='1' visible='true'") +
                                    way(2, {1, 2}, "second", "version='2' visible='true'")));
    EXPECT_EQ(joinedOf(folder, {history}).streets, (Names{"second"}));
}

TEST(MapFiles, AnObjectAtTheSeamOfTwoExtractsStandsOnce)
{
    const TestFolder folder("maps");
    const auto west = folder.write("west.osm", osm(node(1, 0) + node(2, 1) + node(3, 2) +
                                                   way(1, {1, 2, 3}, "seam") + way(2, {1, 2}, "west")));
    const auto east =
        folder.write("east.osm", osm(node(2, 1) + node(3, 2) + node(4, 3) + way(1, {2, 3}, "seam") +
                                     way(3, {3, 4}, "east"))); // cut at the seam
    const auto joined = joinedOf(folder, {east, west});
    EXPECT_EQ(joined.streets, (Names{"seam", "west", "east"}));
    EXPECT_EQ(joined.map.ways.front().nodes.size(), 3u) << "the whole one stays";
    EXPECT_EQ(joined.map.nodes.size(), 4u);
}

TEST(MapFiles, PackedFilesFoldersAndArchivesAreRead)
{
    const TestFolder folder("maps");
    const std::string other = osm(node(8, 8) + node(9, 9) + way(7, {8, 9}, "z"));
    std::ofstream(folder / "a.osm.bz2", std::ios::binary) << bzip2Of(kPlain);
    EXPECT_EQ(joinedOf(folder, {folder / "a.osm.bz2"}).streets, (Names{"a", "b"}));
    writeZip(folder / "maps.zip", {{"readme.txt", "maps"},
                                   {"in/a.osm", kPlain},
                                   {"in/z.osm.bz2", bzip2Of(other)},
                                   {"__MACOSX/._a.osm", "x"}});
    EXPECT_EQ(joinedOf(folder, {folder / "maps.zip"}).error, "");
    EXPECT_EQ(joinedOf(folder, {folder / "maps.zip"}).streets, (Names{"a", "b", "z"}));
    folder.write("a.opl", "n1 x1.5 y42.5\nn2 x1.501 y42.5\nw1 Thighway=residential,name=o Nn1,n2\n");
    EXPECT_EQ(joinedOf(folder, {folder / "a.opl"}).streets, (Names{"o"}));
    std::filesystem::create_directories(folder / "extracts/more");
    folder.write("extracts/plain.osm", kPlain);
    folder.write("extracts/notes.txt", "notes");
    folder.write("extracts/more/z.osm", other);
    folder.write("extracts/.hidden.osm", "no map");
    EXPECT_EQ(joinedOf(folder, {folder / "extracts"}).streets, (Names{"a", "b", "z"}));
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
        EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr(".part-"))) << "left over";
}

TEST(MapFiles, WhatIsNoMapIsToldAtOnce)
{
    const TestFolder folder("maps");
    const auto messageOf = [&](const std::filesystem::path& file)
    {
        const auto sources = mapSourcesOf({file});
        return sources ? std::string("it was taken") : sources.error().message();
    };
    EXPECT_THAT(messageOf(folder / "none.osm"), HasSubstr("no such file"));
    EXPECT_THAT(messageOf(folder.write("empty.osm", "")), HasSubstr("is empty"));
    EXPECT_THAT(messageOf(folder.write("map.txt", "no")), HasSubstr("in no format of maps"));
    EXPECT_THAT(messageOf(folder.write("map.tar.gz", "no")), HasSubstr("unpack it"));
    EXPECT_THAT(messageOf(folder.write("map.7z", "no")), HasSubstr("unpack it"));
    EXPECT_THAT(messageOf(folder.write("map.zip", "no")), HasSubstr("cannot be read as a .zip"));
    EXPECT_THAT(messageOf(folder.write("page.osm", "\n<!DOCTYPE html><html>504</html>")),
                HasSubstr("web server"));
    EXPECT_THAT(messageOf(folder.write("over.json", R"({"version": 0.6, "osm3s": {}, "elements": []})")),
                HasSubstr("[out:xml]"));
    std::filesystem::create_directory(folder / "folder");
    EXPECT_THAT(messageOf(folder / "folder"), HasSubstr("folder without a map"));
    writeZip(folder / "text.zip", {{"readme.txt", "maps"}});
    EXPECT_THAT(messageOf(folder / "text.zip"), HasSubstr("no map in it"));
    EXPECT_EQ(messageOf(folder.write("map.xml", kPlain)), "it was taken");
    EXPECT_TRUE(isMapName("x/map.OSM.PBF"));
    EXPECT_FALSE(isMapName("N42E001.hgt.zip"));
    EXPECT_FALSE(isMapName("ground.tif"));
}

TEST(MapFiles, WhatIsDamagedNamesItsFile)
{
    const TestFolder folder("maps");
    const auto good = folder.write("good.osm", kPlain), bad = folder.write("bad.osm", kPlain.substr(0, 300));
    EXPECT_THAT(joinedOf(folder, {good, bad}).error,
                HasSubstr("bad.osm: cannot be read as OpenStreetMap data"));
    EXPECT_THAT(joinedOf(folder, {good, folder.write("bad.osc", "<osmChange version='0.6'><create>")}).error,
                HasSubstr("bad.osc: cannot be read"));
    EXPECT_THAT(joinedOf(folder, {good, folder.write("bad.osm.pbf", "no")}).error, HasSubstr("bad.osm.pbf"));
}

TEST(MapFiles, ShapesOfTwoLayersThatAreTheSameStandOnce)
{
    const TestFolder folder("maps");
    const auto layer = [&](const char* name, const char* more)
    {
        return folder.write(
            name, std::string(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties":
 {"highway": "residential", "name": "seam"}, "geometry": {"type": "LineString", "coordinates": [[1.5, 42.5], [1.501, 42.5]]}})") +
                      more + "]}");
    };
    const char* const kMore = R"(,{"type": "Feature", "properties": {"highway": "residential", "name": "own"},
 "geometry": {"type": "LineString", "coordinates": [[1.501, 42.5], [1.502, 42.5]]}})";
    auto map = readLand(layer("a.geojson", ""));
    auto other = readLand(layer("b.geojson", kMore));
    ASSERT_TRUE(map && other);
    StreetMap streets = streetsOf(*map);
    EXPECT_EQ(joinLand(*map, std::move(*other)), 1u);
    EXPECT_EQ(map->shapes.size(), 2u);
    LandMap last;
    last.shapes.push_back(map->shapes.back());
    joinStreets(streets, streetsOf(last));
    EXPECT_EQ(streets.ways.size(), 2u);
    EXPECT_EQ(streets.nodes.size(), 3u) << "they meet";
    EXPECT_NE(streets.ways[0].id, streets.ways[1].id);
}

} // namespace
