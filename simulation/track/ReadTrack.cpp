// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ReadTrack.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include <foundation/ReadableFile.h>
#include <foundation/SmallLetters.h>
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
    return foundation::inSmallLetters(file.extension().string());
}

/// Which file of a zip archive is looked at first: doc.kml, another KML file, another recording, text,
/// others. What macOS lays beside each file is none.
int rankOfFile(std::string_view name)
{
    const std::filesystem::path file(name);
    if (name.starts_with("__MACOSX/")) return -1;
    if (name == "doc.kml") return 0;
    const std::string extension = extensionOf(file);
    if (extension == ".kml") return 1;
    if (namesTrackFile(file)) return 2;
    return extension == ".txt" ? 3 : 4;
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

/// The extension that tells the format of a file.
std::string formatOf(const std::filesystem::path& file)
{
    return extensionOf(file) == ".gz" ? extensionOf(file.stem()) : extensionOf(file);
}

foundation::Result<TrackReading> parse(std::string_view text, const std::string& name,
                                       const std::string& extension)
{
    if (extension == ".igc") return parseIgc(text, name);
    if (extension == ".gpx") return parseGpx(text, name);
    if (extension == ".kml" || extension == ".kmz") return parseKml(text, name);
    if (extension == ".csv") return parseTrackTable(text, name);
    if (extension == ".acmi") return parseAcmi(text, name);
    if (extension == ".zip")
        return foundation::Error{name, "holds no recording", "pack an .igc, .gpx, .kml, .acmi or .csv file"};
    return foundation::Error{name, "is no track file by its name",
                             "name an .igc, .gpx, .kml, .kmz, .acmi or .csv file"};
}

/// Adds what a further file of an archive has.
void append(TrackReading& reading, TrackReading more, const std::string& name)
{
    std::move(more.tracks.begin(), more.tracks.end(), std::back_inserter(reading.tracks));
    for (TrackProblem& problem : more.problems)
        reading.problems.push_back({problem.line, name + ": " + problem.what});
    for (TrackProblem& note : more.notes)
        reading.notes.push_back({note.line, name + ": " + note.what});
    reading.problemCount += more.problemCount;
}

/// Reads doc.kml of a zip archive, to which the other files of a KMZ belong; where it has no position, or
/// there is none, all recordings.
foundation::Result<TrackReading> parseZip(std::string_view zip, const std::filesystem::path& file)
{
    std::optional<foundation::Result<TrackReading>> reading;
    const auto take = [&](ZipFile inside)
    {
        const bool isRecording = inside.name.empty() || rankOfFile(inside.name) < 3;
        if (reading && !isRecording) return false; // the error of a recording says more
        const std::string at = file.string() + (inside.name.empty() ? "" : ": " + inside.name);
        foundation::Result<TrackReading> read =
            inside.text
                ? parse(*inside.text, file.string(),
                        formatOf(namesTrackFile(inside.name) ? std::filesystem::path(inside.name) : file))
                : foundation::Error{at, inside.reason, "copy the archive again, or unpack it"};
        const bool isRead = static_cast<bool>(read);
        if (isRead && reading && *reading)
            append(**reading, std::move(*read), inside.name);
        else if (isRead || !reading)
            reading.emplace(std::move(read));
        return isRead && inside.name == "doc.kml";
    };
    forEachFileOfZip(zip, rankOfFile, take);
    if (reading) return std::move(*reading);
    return foundation::Error{file.string(), "is a damaged zip archive", "copy it again, or unpack it"};
}

} // namespace

bool isTrackFile(const std::filesystem::path& file)
{
    return namesTrackFile(file) || extensionOf(file) == ".zip";
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
    if (text.starts_with("\x1F\x8B"))
    {
        constexpr int kGzip = 16;
        auto unpacked = inflated(text, kGzip + MAX_WBITS);
        if (!unpacked)
            return foundation::Error{name, "is damaged by its checksum", "copy it again, or unpack it"};
        text = std::move(*unpacked);
    }
    auto reading = text.starts_with("PK\x03\x04") ? parseZip(text, file) : parse(text, name, formatOf(file));
    if (reading) nameTracks(*reading, file);
    return reading;
}

} // namespace simulation
