// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ReadTrack.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <utility>

#include <foundation/ReadableFile.h>
#include <zlib.h>

#include "simulation/scenario/Trajectory.h"

namespace simulation
{
namespace
{

constexpr std::uintmax_t kMostTrackBytes = 256u << 20;
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

/// What a compressed stream holds. `windowBits`: as of inflateInit2(). Nothing where it is damaged or holds
/// too much.
std::optional<std::string> inflated(std::string_view bytes, int windowBits)
{
    z_stream stream;
    std::memset(&stream, 0, sizeof stream);
    if (inflateInit2(&stream, windowBits) != Z_OK) return std::nullopt;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    int status = Z_OK;
    while (status == Z_OK && text.size() <= kMostTrackBytes)
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
    if (status != Z_STREAM_END) return std::nullopt;
    return text;
}

/// The text of the first file of a zip archive. Source: PKWARE, *.ZIP file format specification*, 4.3.7.
std::optional<std::string> firstOfZip(std::string_view zip)
{
    if (zip.size() < kZipHeader) return std::nullopt;
    const std::size_t method = word(zip, 8);
    const std::size_t begin = kZipHeader + word(zip, 26) + word(zip, 28);
    if (begin > zip.size()) return std::nullopt;
    if (method == Z_DEFLATED) return inflated(zip.substr(begin), -MAX_WBITS);
    const std::size_t stored = word(zip, 18) | word(zip, 20) << 16;
    if (method != 0 || stored == 0 || stored > zip.size() - begin) return std::nullopt;
    return std::string(zip.substr(begin, stored));
}

/// Puts the content of a compressed file in its place.
foundation::Outcome unpack(std::string& text, const std::string& name)
{
    constexpr int kGzip = 16;
    const bool isZip = text.starts_with("PK\x03\x04");
    if (!isZip && !text.starts_with("\x1F\x8B")) return foundation::success();
    std::optional<std::string> unpacked = isZip ? firstOfZip(text) : inflated(text, kGzip + MAX_WBITS);
    if (!unpacked)
        return foundation::Error{name, isZip ? "is a damaged zip archive" : "is damaged by its checksum",
                                 "copy it again, or unpack it"};
    text = std::move(*unpacked);
    return foundation::success();
}

/// Tracks without a name have that of the file; those of the same name are numbered.
void nameTracks(TrackReading& reading, const std::filesystem::path& file)
{
    std::string stem = file.stem().string();
    if (extensionOf(file) == ".gz" || stem.ends_with(".txt") || stem.ends_with(".zip"))
        stem = std::filesystem::path(stem).stem().string();
    std::map<std::string, int> counts;
    for (FlightTrack& track : reading.tracks)
    {
        constexpr std::size_t kLongest = 200; // a scenario's names have 256 characters at most
        if (track.name.empty() || track.name == file.string()) track.name = stem;
        track.name.resize(std::min(track.name.size(), kLongest));
        const int count = ++counts[track.name];
        if (count > 1) track.name += " " + std::to_string(count);
    }
}

foundation::Result<TrackReading> parse(std::string_view text, const std::filesystem::path& file)
{
    const std::string name = file.string();
    const std::string extension = extensionOf(file) == ".gz" ? extensionOf(file.stem()) : extensionOf(file);
    if (extension == ".igc") return parseIgc(text, name);
    if (extension == ".gpx") return parseGpx(text, name);
    if (extension == ".kml" || extension == ".kmz") return parseKml(text, name);
    if (extension == ".csv") return parseTrackTable(text, name);
    if (extension == ".acmi") return parseAcmi(text, name);
    return foundation::Error{name, "is no track file by its name",
                             "name an .igc, .gpx, .kml, .kmz, .acmi or .csv file"};
}

} // namespace

bool isTrackFile(const std::filesystem::path& file)
{
    return namesTrackFile(file);
}

foundation::Result<TrackReading> readTracks(const std::filesystem::path& file)
{
    if (foundation::Outcome readable = foundation::checkReadable(file); !readable) return readable.error();
    const std::string name = file.string();
    std::error_code code;
    if (std::filesystem::file_size(file, code) > kMostTrackBytes || code)
        return foundation::Error{name, "is larger than 256 MiB", "split the recording"};
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (const auto unpacked = unpack(text, name); !unpacked) return unpacked.error();
    auto reading = parse(text, file);
    if (reading) nameTracks(*reading, file);
    return reading;
}

} // namespace simulation
