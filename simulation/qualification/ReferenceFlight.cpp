// SPDX-License-Identifier: Apache-2.0
#include "simulation/qualification/ReferenceFlight.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <foundation/ReadableFile.h>
#include <zlib.h>

namespace simulation
{

namespace
{

constexpr double kFoot = 0.3048;
constexpr double kPound = 0.45359237;
constexpr double kPoundForce = 4.4482216152605;
constexpr std::size_t kMostFlightBytes = 256U << 20U;

/// A column of the file and what it is added to.
struct Column
{
    std::string_view caption;
    FlightChannel channel;
    double scale = 1.0;
};

constexpr std::array<Column, 24> kColumns{{{"Time", FlightChannel::time},
                                           {"lat_deg", FlightChannel::latitudeDeg},
                                           {"lon_deg", FlightChannel::longitudeDeg},
                                           {"alt_msl_ft", FlightChannel::height, kFoot},
                                           {"roll_rad", FlightChannel::roll},
                                           {"pitch_rad", FlightChannel::pitch},
                                           {"heading_rad", FlightChannel::heading},
                                           {"tas_fps", FlightChannel::airspeed, kFoot},
                                           {"climb_fps", FlightChannel::climb, kFoot},
                                           {"alpha_rad", FlightChannel::alpha},
                                           {"beta_rad", FlightChannel::beta},
                                           {"p_rad_s", FlightChannel::rollRate},
                                           {"q_rad_s", FlightChannel::pitchRate},
                                           {"r_rad_s", FlightChannel::yawRate},
                                           {"nz", FlightChannel::loadFactor},
                                           {"elevator_cmd", FlightChannel::elevator},
                                           {"pitch_trim_cmd", FlightChannel::elevator},
                                           {"aileron_cmd", FlightChannel::aileron},
                                           {"rudder_cmd", FlightChannel::rudder},
                                           {"flap_norm", FlightChannel::flaps},
                                           {"throttle", FlightChannel::throttle},
                                           {"rpm", FlightChannel::rpm},
                                           {"thrust_lbs", FlightChannel::thrust, kPoundForce},
                                           {"weight_lbs", FlightChannel::mass, kPound}}};

/// The whole text of a file, unpacked where it is packed.
foundation::Result<std::string> readText(const std::filesystem::path& file)
{
    if (const foundation::Outcome readable = foundation::checkReadable(file); !readable)
        return readable.error();
    const gzFile stream = gzopen(file.c_str(), "rb");
    if (!stream) return foundation::Error{file.string(), "cannot be opened", "check its permissions"};
    std::string text;
    std::array<char, 1U << 16U> part{};
    int bytes = 0;
    while (text.size() < kMostFlightBytes && (bytes = gzread(stream, part.data(), part.size())) > 0)
        text.append(part.data(), static_cast<std::size_t>(bytes));
    gzclose(stream);
    if (bytes < 0) return foundation::Error{file.string(), "is damaged", "copy it again"};
    return text;
}

std::vector<std::string_view> fieldsOf(std::string_view line)
{
    std::vector<std::string_view> fields;
    for (std::size_t at = 0; at <= line.size();)
    {
        const std::size_t comma = std::min(line.find(',', at), line.size());
        fields.push_back(line.substr(at, comma - at));
        at = comma + 1;
    }
    return fields;
}

/// Which field feeds which column.
foundation::Result<std::vector<std::size_t>> findColumns(const std::string& name, std::string_view head)
{
    const std::vector<std::string_view> captions = fieldsOf(head);
    std::vector<std::size_t> places;
    for (const Column& column : kColumns)
    {
        const auto found = std::find(captions.begin(), captions.end(), column.caption);
        if (found == captions.end())
            return foundation::Error{name + ":1", "has no column '" + std::string(column.caption) + "'",
                                     "log it anew with track_directive.xml"};
        places.push_back(static_cast<std::size_t>(found - captions.begin()));
    }
    return places;
}

} // namespace

void unwindHeadings(Flight& flight)
{
    constexpr double kTurn = 2.0 * std::numbers::pi;
    for (std::size_t i = 1; i < flight.size(); ++i)
    {
        const double before = flight[i - 1][FlightChannel::heading];
        double& heading = flight[i][FlightChannel::heading];
        heading -= kTurn * std::round((heading - before) / kTurn);
    }
}

foundation::Result<Flight> readReferenceFlight(const std::filesystem::path& file)
{
    const foundation::Result<std::string> text = readText(file);
    if (!text) return text.error();
    std::istringstream stream(*text);
    std::string line;
    std::getline(stream, line);
    const auto places = findColumns(file.string(), line);
    if (!places) return places.error();
    const std::size_t width = fieldsOf(line).size();
    Flight flight;
    for (std::size_t number = 2; std::getline(stream, line); ++number)
    {
        const std::vector<std::string_view> fields = fieldsOf(line);
        const std::string place = file.string() + ":" + std::to_string(number);
        if (fields.size() != width)
            return foundation::Error{
                place, "has " + std::to_string(fields.size()) + " fields of " + std::to_string(width),
                "copy the file again"};
        FlightRow row;
        for (std::size_t i = 0; i < kColumns.size(); ++i)
        {
            const std::string_view field = fields[(*places)[i]];
            double value = 0.0;
            const auto [end, failed] = std::from_chars(field.data(), field.data() + field.size(), value);
            if (failed != std::errc() || !std::isfinite(value))
                return foundation::Error{place, "'" + std::string(field) + "' is no number",
                                         "copy the file again"};
            row[kColumns[i].channel] += kColumns[i].scale * value;
        }
        if (number > 2) flight.push_back(row);
    }
    if (flight.size() < 2) return foundation::Error{file.string(), "has no rows", "copy the file again"};
    unwindHeadings(flight);
    return flight;
}

} // namespace simulation
