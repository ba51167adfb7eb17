// SPDX-License-Identifier: Apache-2.0
// Recordings inside zip archives. Public reports of the kind: OpenTracks
// 1864 and Organic Maps 7398 (the document is not doc.kml), Organic Maps 12054, 12759 and Cesium 4477 (it
// links to others).
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

#include "simulation/track/ReadTrack.h"

namespace simulation
{
namespace
{

std::string little(std::size_t value, int count)
{
    std::string bytes;
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> (8 * i) & 0xFF);
    return bytes;
}

/// A zip archive of stored files, or of deflated ones.
std::string zipOf(const std::vector<std::pair<std::string, std::string>>& files, bool isDeflated)
{
    std::string zip, directory;
    for (const auto& [name, content] : files)
    {
        std::string packed = content;
        if (isDeflated)
        {
            z_stream stream{};
            EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
            packed.assign(content.size() + 100, '\0');
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
            stream.avail_in = static_cast<uInt>(content.size());
            stream.next_out = reinterpret_cast<Bytef*>(packed.data());
            stream.avail_out = static_cast<uInt>(packed.size());
            EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
            packed.resize(stream.total_out);
            deflateEnd(&stream);
        }
        const std::size_t begin = zip.size();
        const std::string sizes = little(crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                                               static_cast<uInt>(content.size())),
                                         4) +
                                  little(packed.size(), 4) + little(content.size(), 4) +
                                  little(name.size(), 2);
        const std::string head = little(0, 2) + little(isDeflated ? 8 : 0, 2) + little(0, 4);
        zip += "PK\x03\x04" + little(20, 2) + head + sizes + little(0, 2) + name + packed;
        directory += "PK\x01\x02" + little(20, 2) + little(20, 2) + head + sizes + little(0, 2) +
                     little(0, 2) + little(0, 2) + little(0, 2) + little(0, 4) + little(begin, 4) + name;
    }
    return zip + directory + "PK\x05\x06" + little(0, 4) + little(files.size(), 2) + little(files.size(), 2) +
           little(directory.size(), 4) + little(zip.size(), 4) + little(0, 2);
}

std::string lineNamed(const std::string& name)
{
    return "<kml><Placemark><name>" + name +
           "</name><LineString><coordinates>8,46 8,46.1</coordinates></LineString></Placemark></kml>";
}

/// The name of the first track in an archive, or the message.
std::string nameIn(const std::string& zip, const char* file = "a.kmz")
{
    const auto path = std::filesystem::path(testing::TempDir()) / file;
    std::ofstream(path, std::ios::binary) << zip;
    const auto reading = readTracks(path);
    std::filesystem::remove(path);
    return reading ? reading->tracks.at(0).name : reading.error().message();
}

TEST(ZipArchive, TheRecordingIsFoundWhereverItIs)
{
    for (const bool isDeflated : {false, true})
    {
        EXPECT_EQ(
            nameIn(zipOf({{"files/icon.png", "PNG"}, {"flight of today.kml", lineNamed("a")}}, isDeflated)),
            "a");
        EXPECT_EQ(nameIn(zipOf({{"first.kml", lineNamed("b")}, {"doc.kml", lineNamed("a")}}, isDeflated)),
                  "a");
        EXPECT_EQ(nameIn(zipOf({{"b/", ""}, {"b/FIRST.KML", lineNamed("a")}, {"c.kml", lineNamed("b")}},
                               isDeflated)),
                  "a");
        EXPECT_EQ(nameIn(zipOf({{"readme.txt", "words"}, {"x.acmi", "#0\n1,T=8|46|0,Name=a"}}, isDeflated),
                         "f.zip.acmi"),
                  "a");
    }
}

TEST(ZipArchive, DamageIsTold)
{
    const std::string zip = zipOf({{"a.kml", lineNamed("a")}}, true);
    EXPECT_NE(nameIn(zip.substr(0, 60)).find("damaged zip archive"), std::string::npos);
    for (const std::size_t at : {std::size_t{45}, zip.find("PK\x01\x02") + 16, zip.find("PK\x01\x02") + 42})
    {
        std::string broken = zip;
        broken[at] = static_cast<char>(broken[at] ^ 0x55);
        EXPECT_NE(nameIn(broken).find("damaged zip archive"), std::string::npos) << at;
    }
}

TEST(ZipArchive, OtherFilesAreLookedAtWhereTheFirstHasNoPosition)
{
    const std::string link = "<kml><NetworkLink><Link><href>files/a.kml</href></Link></NetworkLink></kml>";
    for (const bool isDeflated : {false, true})
    {
        EXPECT_EQ(nameIn(zipOf({{"doc.kml", link}, {"files/a.kml", lineNamed("a")}}, isDeflated)), "a");
        EXPECT_EQ(nameIn(zipOf(
                      {{"a.kml", "<kml/>"}, {"b.kml", "no XML"}, {"c.gpx", "no"}, {"d.kml", lineNamed("d")}},
                      isDeflated)),
                  "d");
        EXPECT_EQ(
            nameIn(zipOf(
                {{"__MACOSX/._doc.kml", "x"}, {"__MACOSX/a.kml", lineNamed("b")}, {"z.kml", lineNamed("z")}},
                isDeflated)),
            "z");
    }
    // Files of other formats are read as their own names say, in a KMZ and in a plain archive.
    const std::string gpx =
        "<gpx><trk><name>g</name><trkseg><trkpt lat=\"46\" lon=\"8\"/></trkseg></trk></gpx>";
    for (const char* archive : {"f.kmz", "f.zip", "F.ZIP"})
        EXPECT_EQ(nameIn(zipOf({{"readme.txt", "words"}, {"a/b/flight.GPX", gpx}}, true), archive), "g")
            << archive;
    EXPECT_NE(nameIn(zipOf({{"readme.txt", "words"}}, true), "f.zip").find("holds no recording"),
              std::string::npos);
    EXPECT_TRUE(isTrackFile("flights.zip"));
    EXPECT_NE(nameIn(zipOf({{"doc.kml", link}, {"icon.png", "PNG"}}, true)).find("holds no position"),
              std::string::npos);
}

TEST(ZipArchive, AllRecordingsAreReadWhereNoDocumentLeadsThem)
{
    const auto path = std::filesystem::path(testing::TempDir()) / "two.kmz";
    const auto namesIn = [&](const std::vector<std::pair<std::string, std::string>>& files)
    {
        std::ofstream(path, std::ios::binary) << zipOf(files, true);
        const auto reading = readTracks(path);
        std::filesystem::remove(path);
        std::vector<std::string> names;
        if (reading)
            for (const FlightTrack& track : reading->tracks)
                names.push_back(track.name);
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(
        namesIn({{"doc.kml", "<kml/>"}, {"files/b.kml", lineNamed("b")}, {"files/a.kml", lineNamed("a")}}),
        (Names{"b", "a"}));
    EXPECT_EQ(namesIn({{"a.kml", lineNamed("a")}, {"c.kml", "no XML"}, {"b.kml", lineNamed("a")}}),
              (Names{"a", "a 2"}));
    EXPECT_EQ(namesIn({{"b.kml", lineNamed("b")}, {"doc.kml", lineNamed("a")}}), (Names{"a"}));
}

TEST(ZipArchive, WhyAFileCannotBeUnpackedIsTold)
{
    std::string zip = zipOf({{"a.kml", lineNamed("a")}}, true);
    const std::size_t directory = zip.find("PK\x01\x02");
    std::string other = zip;
    other[directory + 10] = 12; // bzip2
    EXPECT_NE(nameIn(other).find("a.kml: is packed by a method that is not read"), std::string::npos)
        << nameIn(other);
    zip[directory + 8] = 1;
    EXPECT_NE(nameIn(zip).find("a.kml: is encrypted"), std::string::npos) << nameIn(zip);
}

} // namespace
} // namespace simulation
