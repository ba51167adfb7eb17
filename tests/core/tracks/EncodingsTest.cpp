// SPDX-License-Identifier: Apache-2.0
// Files that are written in other encodings than UTF-8: their names come out whole.
#include <cmath>

#include <gtest/gtest.h>
#include <iconv.h>

#include <osgRoads/core/read/ReadNetwork.h>

#include "simulation/parser/ParseScenario.h"
#include "simulation/track/ReadTrack.h"

namespace simulation
{
namespace
{

/// A text of UTF-8 in another encoding.
std::string in(const char* encoding, std::string text)
{
    const iconv_t converter = iconv_open(encoding, "UTF-8");
    // NOLINTNEXTLINE(performance-no-int-to-ptr): iconv_open() failed where it is -1
    EXPECT_NE(converter, reinterpret_cast<iconv_t>(-1)) << encoding;
    std::string bytes(4 * text.size() + 16, '\0');
    char *from = text.data(), *to = bytes.data();
    std::size_t left = text.size(), room = bytes.size();
    EXPECT_EQ(iconv(converter, &from, &left, &to, &room), 0u) << encoding;
    iconv_close(converter);
    bytes.resize(bytes.size() - room);
    return bytes;
}

std::string declared(const std::string& encoding)
{
    return encoding.empty() ? std::string() : "<?xml version='1.0' encoding='" + encoding + "'?>\n";
}

struct Encoded
{
    const char* name;
    const char* written; ///< as iconv names it
    const char* declared;
    const char* words; ///< that it can hold, in UTF-8
    const char* mark = "";
};

class Encodings : public testing::TestWithParam<Encoded>
{
protected:
    std::string fileOf(const std::string& content) const
    {
        return GetParam().mark + in(GetParam().written, declared(GetParam().declared) + content);
    }
    const std::string _words = GetParam().words;
};

TEST_P(Encodings, NamesOfGpxAndKmlAreWhole)
{
    const auto gpx = parseGpx(fileOf("<gpx><trk><name>" + _words +
                                     "</name><trkseg><trkpt lat=\"46\" lon=\"8\"/></trkseg></trk></gpx>"),
                              "f.gpx");
    ASSERT_TRUE(gpx) << gpx.error().message();
    EXPECT_EQ(gpx->tracks[0].name, _words);
    EXPECT_EQ(gpx->problemCount + gpx->notes.size(), 0u);
    const auto kml = parseKml(fileOf("<kml><Placemark><name>" + _words +
                                     "</name><LineString><coordinates>8,46 8,47</coordinates></LineString>"
                                     "</Placemark></kml>"),
                              "f.kml");
    ASSERT_TRUE(kml) << kml.error().message();
    EXPECT_EQ(kml->tracks[0].name, _words);
}

TEST_P(Encodings, IdsOfRoadsAndNamesOfEntitiesAreWhole)
{
    const auto roads = osgRoads::core::parseNetwork(
        fileOf("<OpenDRIVE><header revMajor='1' revMinor='6'/><road length='9' id='" + _words +
               "' junction='-1'><planView><geometry s='0' x='0' y='0' hdg='0' length='9'><line/></geometry>"
               "</planView><lanes><laneSection s='0'><center><lane id='0' type='none'/></center><right>"
               "<lane id='-1' type='driving'><width sOffset='0' a='3' b='0' c='0' d='0'/></lane></right>"
               "</laneSection></lanes></road></OpenDRIVE>"),
        "f.xodr");
    ASSERT_TRUE(roads) << roads.error().message();
    EXPECT_EQ(roads->network.roads.at(0).id, _words);
    EXPECT_TRUE(roads->problems.empty());
    ParseOptions options;
    options.tolerant = true;
    const auto scenario = parseScenario(
        fileOf("<OpenSCENARIO><FileHeader revMajor='1' revMinor='2' date='' description='' author=''/>"
               "<Entities><ScenarioObject name='" +
               _words +
               "'><MiscObject mass='1' name='' miscObjectCategory='none'><BoundingBox><Center x='0' y='0' "
               "z='0'/>"
               "<Dimensions width='1' length='1' height='1'/></BoundingBox></MiscObject></ScenarioObject></"
               "Entities><Storyboard><Init><Actions/></Init></Storyboard></OpenSCENARIO>"),
        "f.xosc", options);
    ASSERT_TRUE(scenario) << scenario.error().message();
    EXPECT_EQ(scenario->scenario.entities.at(0).name, _words);
}

INSTANTIATE_TEST_SUITE_P(Table, Encodings,
                         testing::Values(Encoded{"latin1", "ISO-8859-1", "ISO-8859-1", "Straße Ü"},
                                         Encoded{"windows", "CP1252", "windows-1252", "Übung – 5 €"},
                                         Encoded{"windowsCalledLatin", "CP1252", "iso-8859-1", "5 € „Ö“"},
                                         Encoded{"latin9", "ISO-8859-15", "ISO-8859-15", "Œuvre 5 €"},
                                         Encoded{"latin2", "ISO-8859-2", "iso-8859-2", "Łódź žluťoučký"},
                                         Encoded{"cyrillic", "KOI8-R", "KOI8-R", "Москва"},
                                         Encoded{"japanese", "SHIFT_JIS", "Shift_JIS", "東京"},
                                         Encoded{"wideLittle", "UTF-16LE", "UTF-16", "Köln €", "\xFF\xFE"},
                                         Encoded{"wideBig", "UTF-16BE", "UTF-16", "Köln €", "\xFE\xFF"},
                                         Encoded{"wideWithoutMark", "UTF-16BE", "UTF-16", "Köln €"},
                                         Encoded{"mark", "UTF-8", "", "Köln €", "\xEF\xBB\xBF"},
                                         Encoded{"markAgainstTheDeclaration", "UTF-8", "ISO-8859-1", "Köln €",
                                                 "\xEF\xBB\xBF"},
                                         Encoded{"wideByItsDeclarationAlone", "UTF-8", "UTF-16", "Köln €"}),
                         [](const testing::TestParamInfo<Encoded>& test) { return test.param.name; });

const std::string kNotedTable = "time,lat,lon,alt,note Köln\n0,46,8,900,ä\n1,46.1,8,900,ö\n";

TEST(TableEncodings, MarksWideTextsAndLatinAreRead)
{
    for (const std::string& text : {"\xEF\xBB\xBF" + kNotedTable, "\xFF\xFE" + in("UTF-16LE", kNotedTable),
                                    in("UTF-16LE", kNotedTable), "\xFE\xFF" + in("UTF-16BE", kNotedTable)})
    {
        const auto reading = parseTrackTable(text, "f.csv");
        ASSERT_TRUE(reading) << reading.error().message();
        EXPECT_EQ(reading->tracks[0].fixes.size(), 2u);
        EXPECT_TRUE(reading->notes.empty());
    }
    const auto latin = parseTrackTable(in("ISO-8859-1", kNotedTable), "f.csv");
    ASSERT_TRUE(latin) << latin.error().message();
    EXPECT_EQ(latin->tracks[0].fixes.size(), 2u);
    ASSERT_EQ(latin->notes.size(), 1u);
    EXPECT_EQ(latin->notes[0].line, 1);
    EXPECT_EQ(latin->notes[0].what, "3 bytes that are not UTF-8, taken as Windows-1252");
}

TEST(TableEncodings, NamesOfAcmiAreWhole)
{
    for (const std::string& bytes :
         {std::string("1,T=8|46|0,Name=J\xE4ger"), in("UTF-16LE", "1,T=8|46|0,Name=Jäger")})
    {
        const auto reading = parseAcmi(bytes, "f.acmi");
        ASSERT_TRUE(reading) << reading.error().message();
        EXPECT_EQ(reading->tracks[0].name, "Jäger");
    }
}

/// Told with the line, in every reader.
TEST(StrayBytes, WhatCannotBeReadIsToldWithItsLine)
{
    const std::string stray =
        "<?xml version='1.0' encoding='UTF-8'?>\n<gpx>\n<trk><name>K\xF6ln</name><trkseg>"
        "<trkpt lat='46' lon='8'/></trkseg></trk></gpx>";
    const auto reading = parseGpx(stray, "f.gpx");
    ASSERT_TRUE(reading) << reading.error().message();
    EXPECT_EQ(reading->tracks[0].name, "Köln");
    ASSERT_EQ(reading->notes.size(), 1u);
    EXPECT_EQ(reading->notes[0].line, 3);
    const auto roads = osgRoads::core::parseNetwork(
        "<OpenDRIVE>\n<header revMajor='1' revMinor='6' vendor='\xFC'/></OpenDRIVE>", "f.xodr");
    ASSERT_FALSE(roads); // no road
    EXPECT_EQ(parseGpx("<?xml version='1.0' encoding='klingon'?><gpx/>", "f.gpx").error().message(),
              "f.gpx:1: the encoding 'KLINGON' is unknown; save the file as UTF-8");
    EXPECT_EQ(
        parseGpx("<?xml version='1.0' encoding='Shift_JIS'?>\n<gpx>\xFF</gpx>", "f.gpx").error().message(),
        "f.gpx:2: not valid SHIFT_JIS; save the file as UTF-8");
    EXPECT_EQ(parseKml(std::string("\xFF\xFE<\0k\0\n\0\x3C\xD8", 10), "f.kml").error().message(),
              "f.kml:2: not valid UTF-16; save the file as UTF-8");
}

} // namespace
} // namespace simulation
