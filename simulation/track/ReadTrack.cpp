// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ReadTrack.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <optional>
#include <utility>

#include <foundation/ReadableFile.h>
#include <foundation/Utf8.h>
#include <zlib.h>

#include "simulation/scenario/Trajectory.h"
#include "simulation/track/ZipArchive.h"

namespace simulation
{
namespace
{

constexpr std::uintmax_t kMostTrackBytes = 256u << 20;

std::string extensionOf(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// Which file of a zip archive is the recording: doc.kml, another KML file, another recording, text, others.
int rankOfFile(std::string_view name)
{
    const std::filesystem::path file(name);
    if (name == "doc.kml") return 0;
    const std::string extension = extensionOf(file);
    if (extension == ".kml") return 1;
    if (isTrackFile(file)) return 2;
    return extension == ".txt" ? 3 : 4;
}

/// Puts the content of a compressed file in its place.
foundation::Outcome unpack(std::string& text, const std::string& name)
{
    constexpr int kGzip = 16;
    const bool isZip = text.starts_with("PK\x03\x04");
    if (!isZip && !text.starts_with("\x1F\x8B")) return foundation::success();
    std::optional<std::string> unpacked =
        isZip ? fileOfZip(text, rankOfFile) : inflated(text, kGzip + MAX_WBITS);
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
        track.name = std::string(foundation::utf8Beginning(track.name, kLongest));
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
