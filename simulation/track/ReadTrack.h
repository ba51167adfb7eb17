// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Returns whether a file is one of recorded tracks by its name, with .gz after it or without, or an archive
/// (.zip) that may hold some.
bool isTrackFile(const std::filesystem::path& file);

/// Reads the tracks of a file: .igc, .gpx, .kml, .kmz, .acmi, .csv, in small or capital letters; as they are,
/// or compressed by gzip or in a zip archive, of which doc.kml or, where it has no position, all recordings
/// are read, each as its own name says. Each track has a name of its own. Errors, with the line: not a
/// readable file, larger than 256 MiB, of no known kind, damaged as a whole, without any position. A damaged
/// record is a problem of the reading, with its line; the others are read.
foundation::Result<TrackReading> readTracks(const std::filesystem::path& file);

// The same from a text; `name` stands for the file in errors.

/// IGC: the height is that of the satellites, above the ellipsoid, or above the geoid where HFALG says so;
/// without it the pressure altitude. A fix without height (V) has the pressure altitude, moved by the last
/// difference of both.
/// Source: FAI, *Technical specification for GNSS flight recorders*, appendix A (B and H records).
foundation::Result<TrackReading> parseIgc(std::string_view text, const std::string& name);

/// GPX 1.0 and 1.1: each track, its segments one after the other, and each route.
/// Source: Topografix, *GPX 1.1 schema*.
foundation::Result<TrackReading> parseGpx(std::string_view text, const std::string& name);

/// KML: each gx:Track. Source: Google, *KML reference*, gx:Track.
foundation::Result<TrackReading> parseKml(std::string_view text, const std::string& name);

/// ACMI 2: each object that has a position. Source: Tacview, *ACMI 2.2 file format*.
foundation::Result<TrackReading> parseAcmi(std::string_view text, const std::string& name);

/// A table whose first line names its columns: time (seconds, or date and time), latitude, longitude and
/// height, by their usual names, parted by commas, semicolons, tabs or upright lines.
foundation::Result<TrackReading> parseTrackTable(std::string_view text, const std::string& name);

} // namespace simulation
