// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ReadTrack.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>

#include <foundation/ReadableFile.h>
#include <zlib.h>

namespace simulation
{
namespace
{

constexpr std::uintmax_t kMostBytes = 256u << 20;
constexpr std::size_t kZipHeader = 30; ///< bytes of a local file header without its names

std::string extensionOf(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::size_t word(std::string_view bytes, std::size_t at)
{
    return static_cast<unsigned char>(bytes[at]) |
           static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + 1])) << 8;
}

/// The text of the first file of a zip archive. Source: PKWARE, *.ZIP file format specification*, 4.3.7.
foundation::Result<std::string> firstOfZip(std::string_view zip, const std::string& name)
{
    const foundation::Error damaged{name, "is a damaged zip archive", "copy it again, or unpack it"};
    if (zip.size() < kZipHeader) return damaged;
    const std::size_t method = word(zip, 8);
    const std::size_t begin = kZipHeader + word(zip, 26) + word(zip, 28);
    if (begin > zip.size() || method != Z_DEFLATED) return damaged;
    z_stream stream;
    std::memset(&stream, 0, sizeof stream);
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return damaged;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(zip.data() + begin));
    stream.avail_in = static_cast<uInt>(zip.size() - begin);
    std::string text;
    int status = Z_OK;
    while (status == Z_OK && text.size() <= kMostBytes)
    {
        constexpr std::size_t kPiece = 1 << 16;
        const std::size_t before = text.size();
        text.resize(before + kPiece);
        stream.next_out = reinterpret_cast<Bytef*>(text.data() + before);
        stream.avail_out = kPiece;
        status = inflate(&stream, Z_NO_FLUSH);
        text.resize(before + kPiece - stream.avail_out);
    }
    inflateEnd(&stream);
    if (status != Z_STREAM_END) return damaged;
    return text;
}

} // namespace

foundation::Result<TrackReading> readTracks(const std::filesystem::path& file)
{
    if (foundation::Outcome readable = foundation::checkReadable(file); !readable) return readable.error();
    const std::string name = file.string();
    std::error_code code;
    if (std::filesystem::file_size(file, code) > kMostBytes || code)
        return foundation::Error{name, "is larger than 256 MiB", "split the recording"};
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::string extension = extensionOf(file);
    if (extension == ".igc") return parseIgc(text, name);
    if (extension == ".gpx") return parseGpx(text, name);
    if (extension == ".kml") return parseKml(text, name);
    if (extension == ".csv") return parseTrackTable(text, name);
    if (extension != ".acmi")
        return foundation::Error{name, "is no track file by its name",
                                 "name an .igc, .gpx, .kml, .acmi or .csv file"};
    if (!text.starts_with("PK\x03\x04")) return parseAcmi(text, name);
    const auto unpacked = firstOfZip(text, name);
    if (!unpacked) return unpacked.error();
    return parseAcmi(*unpacked, name);
}

} // namespace simulation
