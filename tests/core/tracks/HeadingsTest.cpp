// SPDX-License-Identifier: Apache-2.0
// Tables of positions with headings in other languages, and coordinates as people write them.
#include <cmath>

#include <gtest/gtest.h>

#include "simulation/track/HeadingWords.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TableColumns.h"

namespace simulation
{
namespace
{

struct HeadedTable
{
    const char* name;
    std::string text; ///< two places, a second apart
    double latitudeDeg = 51.4778, longitudeDeg = -0.0015, heightM = 45.5;
    HeightDatum datum = HeightDatum::meanSeaLevel;
};

class TableHeadings : public testing::TestWithParam<HeadedTable>
{
};

TEST_P(TableHeadings, TellWhatTheColumnsHold)
{
    const auto read = parseTrackTable(GetParam().text, "t.csv");
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->problemCount, 0u) << read->problems[0].what;
    ASSERT_EQ(read->tracks.size(), 1u);
    const FlightTrack& track = read->tracks[0];
    ASSERT_EQ(track.fixes.size(), 2u);
    EXPECT_TRUE(track.hasTimes);
    EXPECT_NEAR(track.fixes[1].timeS - track.fixes[0].timeS, 1.0, 1e-9);
    EXPECT_NEAR(track.fixes[0].latitudeDeg, GetParam().latitudeDeg, 1e-9);
    EXPECT_NEAR(track.fixes[0].longitudeDeg, GetParam().longitudeDeg, 1e-9);
    ASSERT_TRUE(track.fixes[0].heightM);
    EXPECT_NEAR(*track.fixes[0].heightM, GetParam().heightM, 1e-9);
    EXPECT_EQ(track.datum, GetParam().datum);
}

/// Two rows of numbers behind a heading; `mark` parts them.
std::string rowsBelow(const std::string& heading, const std::string& row)
{
    std::string text = heading + "\n";
    for (const char* time : {"12:00:00", "12:00:01"})
    {
        std::string line = row;
        line.replace(line.find('T'), 1, time);
        text += line + "\n";
    }
    return text;
}

const std::string kRow = "T;51,4778;-0,0015;45,5;3;90";

INSTANTIATE_TEST_SUITE_P(
    Languages, TableHeadings,
    testing::Values(
        HeadedTable{"German", rowsBelow("Uhrzeit;Breite;Länge;Höhe [m];Geschwindigkeit;Kurs", kRow)},
        HeadedTable{"GermanCapitals",
                    rowsBelow("ZEIT;BREITENGRAD;LÄNGENGRAD;HÖHE;GESCHWINDIGKEIT;KURS", kRow)},
        HeadedTable{"GermanSpelledOut",
                    rowsBelow("Zeit;geo_breite;geo_laenge;Hoehe_ueber_NN;v;Richtung", kRow)},
        HeadedTable{"GermanDecomposed", rowsBelow("Zeit;Breite;La\xCC\x88nge;Ho\xCC\x88he;v;Kurs", kRow)},
        HeadedTable{"GermanPressure", rowsBelow("Zeit;Breite;Länge;Druckhöhe;v;Kurs", kRow), 51.4778, -0.0015,
                    45.5, HeightDatum::pressure},
        HeadedTable{"French", rowsBelow("Heure;Latitude;Longitude;Altitude;Vitesse;Cap", kRow)},
        HeadedTable{"FrenchTime", rowsBelow("temps;lat;lon;élévation (m);vitesse;cap", kRow)},
        HeadedTable{"FrenchGround", rowsBelow("temps;lat;lon;hauteur sol;vitesse;cap", kRow), 51.4778,
                    -0.0015, 45.5, HeightDatum::ground},
        HeadedTable{"Spanish", rowsBelow("Hora;Latitud;Longitud;Altitud;Velocidad;Rumbo", kRow)},
        HeadedTable{"SpanishFeet", rowsBelow("Tiempo;Latitud;Longitud;Altitud (pies);Velocidad;Rumbo", kRow),
                    51.4778, -0.0015, 45.5 * 0.3048},
        HeadedTable{"Italian", rowsBelow("Ora;Latitudine;Longitudine;Quota;Velocità;Rotta", kRow)},
        HeadedTable{"Dutch", rowsBelow("Tijd;Breedtegraad;Lengtegraad;Hoogte;Snelheid;Koers", kRow)},
        HeadedTable{"Portuguese", rowsBelow("Hora;Latitude;Longitude;Elevação;Velocidade;Rumo", kRow)},
        // A height that says from where goes before one that does not, in all languages.
        HeadedTable{"TheSurerHeight",
                    rowsBelow("Zeit;Breite;Länge;Höhe;Höhe ü. Meer;Kurs", "T;51,4778;-0,0015;7;45,5;90")},
        HeadedTable{"NoRate", rowsBelow("Zeit;Breite;Länge;Höhe Geschwindigkeit;Höhe;Kurs",
                                        "T;51,4778;-0,0015;7;45,5;90")},
        // English words go first where a word is one of another language, too.
        HeadedTable{"TempsIsNoTime", rowsBelow("temps;lat;lon;alt;time", "21;51,4778;-0,0015;45,5;T")}),
    [](const testing::TestParamInfo<HeadedTable>& test) { return std::string(test.param.name); });

std::string above(const std::string& place)
{
    return "time,latitude,longitude,height\n0," + place + ",45.5\n1," + place + ",45.5\n";
}

constexpr double kSouth = -(33.0 + 51.0 / 60.0 + 24.0 / 3600.0), kEast = 151.0 + 12.5 / 60.0;

INSTANTIATE_TEST_SUITE_P(
    Coordinates, TableHeadings,
    testing::Values(
        HeadedTable{"Signs", above("33°51'24\"S,151° 12.5' E"), kSouth, kEast},
        HeadedTable{"Primes", above("33°51′24″S,151°12′30″E"), kSouth, kEast},
        HeadedTable{"CurvedQuotes", above("S 33º 51’ 24”,E 151º 12’ 30”"), kSouth, kEast},
        HeadedTable{"TwoMinuteSigns", above("33°51'24''S,151°12'30''E"), kSouth, kEast},
        HeadedTable{"Blanks", above("33 51 24 S,151 12.5E"), kSouth, kEast},
        HeadedTable{"Signed", above("-33 51 24,151 12.5"), kSouth, kEast},
        HeadedTable{"Colons", above("-33:51:24,+151:12:30.0"), kSouth, kEast},
        HeadedTable{"Dashes", above("33-51-24S,151-12-30E"), kSouth, kEast},
        HeadedTable{"Words", above("33 deg 51 min 24 sec S,151 deg 12.5 min E"), kSouth, kEast},
        HeadedTable{"DecimalComma",
                    "time;latitude;longitude;height\n0;33 51,4S;151 12,5E;45,5\n1;33 51,4S;151 12,5E;45,5\n",
                    kSouth, kEast},
        HeadedTable{"OfGreenwich", above("51°28'40.08\"N,0°0'5.4\"W")},
        HeadedTable{"InOneCell",
                    "time,position,height agl\n0,\"33°51'24\"\"S, 151°12.5'E\",10\n1,\"33°51'24\"\"S, "
                    "151°12.5'E\",10\n",
                    kSouth, kEast, 10 * 0.3048, HeightDatum::ground},
        HeadedTable{"Exponents", above("5.14778e1,-1.5e-03")},
        HeadedTable{"SevenPlaces",
                    "time,latitudeE7,longitudeE7,height\n0,514778000,-15000,45.5\n1,514778000,-15000,45.5\n"},
        HeadedTable{"SevenPlacesOfOthers",
                    "time,lat_e7,lon_e7,alt_mm\n0,514778000,-15000,45500\n1,514778000,-15000,45500\n"},
        HeadedTable{"SixPlaces", "time,latE6,lngE6,height\n0,51477800,-1500,45.5\n1,51477800,-1500,45.5\n"},
        HeadedTable{"EastOfGermans",
                    "Zeit;Breite;Länge;Höhe\n0;51,4778 N;8,5 O;45,5\n1;51,4778 N;8,5 O;45,5\n", 51.4778, 8.5},
        HeadedTable{"WestOfSpaniards",
                    "hora;latitud;longitud;altitud\n0;51,4778 N;8,5 O;45,5\n1;51,4778 N;8,5 O;45,5\n",
                    51.4778, -8.5}),
    [](const testing::TestParamInfo<HeadedTable>& test) { return std::string(test.param.name); });

/// What is said of a place of a table; it is not read.
std::string saidOf(const std::string& place, const std::string& heading = "latitude,longitude")
{
    const auto read = parseTrackTable("time,height," + heading + "\n0,1,51,7\n1,1," + place + "\n", "t.csv");
    if (!read || read->problemCount != 1 || read->problems[0].line != 3) return "not told with its line";
    return read->problems[0].what;
}

TEST(Coordinates, ThatAreAmbiguousAreToldWithTheirLine)
{
    EXPECT_NE(saidOf("51,8.5 O").find("O is east in German and Dutch, and west in French"), std::string::npos)
        << saidOf("51,8.5 O");
    EXPECT_NE(saidOf("-51.5 S,7").find("a sign and the letter S"), std::string::npos);
    EXPECT_NE(saidOf("51.5 E,7").find("the letter E is of the other coordinate"), std::string::npos);
    EXPECT_NE(saidOf("51 60.5,7").find("60 or more"), std::string::npos);
    EXPECT_NE(saidOf("51.5 30,7").find("behind a part of a degree"), std::string::npos);
    EXPECT_NE(saidOf("51.5,7", "latE7,lonE7").find("no whole number"), std::string::npos);
    EXPECT_NE(saidOf("514778000,7").find("within 90 degrees"), std::string::npos);
    EXPECT_NE(saidOf("5128.668N,7").find("within 90 degrees"), std::string::npos);
    for (const char* none : {"51 -7,8", "51' 30,7", "51°30°,7", "51 28 40 12,7", "51 N 7 E,7", "N,7", "51x,7",
                             "--51,7", "51..5,7", ":51,7"})
        EXPECT_EQ(saidOf(none), "latitude or longitude is no number") << none;
    EXPECT_EQ(saidOf("52,7"), "not told with its line") << "the control: nothing is wrong with it";
}

TEST(HeadingWords, LoseTheirAccents)
{
    EXPECT_EQ(headingWords("geoHöhe_über-Straße[m]"),
              (std::vector<std::string>{"geo", "hohe", "uber", "strasse", "m", ""}));
    EXPECT_EQ(inEnglish({"meereshohe", "x", ""}), (std::vector<std::string>{"altitude", "msl", "x", ""}));
}

TEST(Headings, OfOtherLanguagesHaveTheDayFirst)
{
    const auto at = [](const std::string& heading)
    {
        const auto read = parseTrackTable(heading + "\n03/04/2026 12:00:00,51,7,1\n", "t.csv");
        return read && !read->tracks.empty() ? read->tracks[0].fixes[0].timeS : 0.0;
    };
    constexpr double kMarchFourth = 1772625600.0, kAprilThird = 1775217600.0;
    EXPECT_EQ(at("time,latitude,longitude,height"), kMarchFourth);
    EXPECT_EQ(at("heure,latitude,longitude,altitude"), kAprilThird);
    EXPECT_EQ(at("Zeit,Breite,Länge,Höhe"), kAprilThird);
}

} // namespace
} // namespace simulation
