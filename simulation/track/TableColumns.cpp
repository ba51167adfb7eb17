// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TableColumns.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include <foundation/Units.h>

#include "simulation/track/HeadingWords.h"

namespace simulation
{
namespace
{

using Words = std::vector<std::string>;

bool hasWord(const Words& words, std::initializer_list<std::string_view> wanted)
{
    return std::find_first_of(words.begin(), words.end(), wanted.begin(), wanted.end()) != words.end();
}

/// The first column whose first word is one of those wanted, else one that has such a word.
int columnOf(const std::vector<Words>& names, std::initializer_list<std::string_view> wanted)
{
    for (const bool isByFirst : {true, false})
        for (std::size_t i = 0; i < names.size(); ++i)
            if (hasWord(isByFirst ? Words{names[i].front()} : names[i], wanted)) return static_cast<int>(i);
    return TableColumns::kNone;
}

struct HeightKind
{
    int rank = 0; ///< the highest is taken
    HeightDatum datum = HeightDatum::meanSeaLevel;
};

/// What a column of heights holds; nothing: it is none.
std::optional<HeightKind> heightKind(const Words& words)
{
    const std::initializer_list<std::string_view> names = {
        "height", "altitude", "alt", "elevation", "ele", "elev", "geoaltitude", "baroaltitude"};
    if (!hasWord(words, names) || hasWord(words, {"rate", "speed", "accuracy", "error", "sigma", "status",
                                                  "valid", "source", "type", "mode", "sonar"}))
        return std::nullopt;
    if (hasWord(words, {"ellipsoid", "ellipsoidal", "hae", "geoaltitude", "geom", "geometric"}))
        return HeightKind{4, HeightDatum::ellipsoid};
    if (hasWord(words, {"msl", "amsl", "sea", "orthometric"}))
        return HeightKind{4, HeightDatum::meanSeaLevel};
    if (hasWord(words, {"agl", "ground", "relative", "rel", "takeoff", "home"}))
        return HeightKind{0, HeightDatum::ground};
    if (hasWord(words, {"baro", "baroaltitude", "barometric", "pressure", "qne"}))
        return HeightKind{1, HeightDatum::pressure};
    return HeightKind{hasWord({words.front()}, names) ? 3 : 2, HeightDatum::meanSeaLevel};
}

/// The columns that may tell which object a row is of: by address, registration, number, then by names that
/// may change on the way.
std::vector<int> idColumns(const std::vector<std::string>& cells)
{
    constexpr std::string_view kNames[] = {
        "icao24",     "icao",        "icaoaddress",  "icaohex",   "modes",    "hex",          "hexid",
        "hexident",   "mmsi",        "registration", "reg",       "tail",     "tailnumber",   "tailnum",
        "aircraftid", "aircraft",    "acid",         "vehicleid", "vehicle",  "vesselid",     "vessel",
        "objectid",   "object",      "entityid",     "entity",    "deviceid", "device",       "droneid",
        "uavid",      "tracknumber", "trackid",      "flightid",  "id",       "flightnumber", "callsign",
        "ident",      "flight",      "name"};
    std::vector<std::string> letters;
    for (const std::string& cell : cells)
    {
        letters.emplace_back();
        for (const char c : cell)
            if (std::isalnum(static_cast<unsigned char>(c)))
                letters.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    std::vector<int> columns;
    for (const std::string_view name : kNames)
        for (std::size_t i = 0; i < letters.size(); ++i)
            if (letters[i] == name) columns.push_back(static_cast<int>(i));
    return columns;
}

double timeUnit(const Words& words)
{
    if (hasWord(words, {"ms", "msec", "millis", "millisecond", "milliseconds"})) return 1e-3;
    if (hasWord(words, {"us", "usec", "micros", "microsecond", "microseconds"})) return 1e-6;
    if (hasWord(words, {"ns", "nanos", "nanosecond", "nanoseconds"})) return 1e-9;
    return 1.0;
}

double heightUnit(const Words& words)
{
    if (hasWord(words, {"ft", "feet", "foot"})) return foundation::kMetresPerFoot;
    if (hasWord(words, {"mm", "millimeters", "millimetres"})) return 1e-3;
    return hasWord(words, {"cm", "centimeters", "centimetres"}) ? 1e-2 : 1.0;
}

/// Of whole numbers below headings such as latitudeE7 and lon_e6.
double unitOfDegrees(std::string_view heading)
{
    while (!heading.empty() && std::isalnum(static_cast<unsigned char>(heading.back())) == 0)
        heading.remove_suffix(1);
    for (const auto& [ending, unit] : {std::pair{"7", 1e-7}, std::pair{"6", 1e-6}})
        if (heading.size() > 2 && heading.ends_with(ending) &&
            (heading[heading.size() - 2] == 'e' || heading[heading.size() - 2] == 'E'))
            return unit;
    return 1.0;
}

SideOfO sideOfO(const Words& words)
{
    if (hasWord(words, {"lange", "laenge", "langengrad", "laengengrad", "geolange", "geolaenge", "lengte",
                        "lengtegraad"}))
        return SideOfO::east;
    return hasWord(words, {"longitud", "longitudine"}) ? SideOfO::west : SideOfO::unknown;
}

} // namespace

TableColumns columnsOf(const std::vector<std::string>& cells)
{
    std::vector<Words> names, english;
    for (const std::string& cell : cells)
    {
        names.push_back(headingWords(cell));
        english.push_back(inEnglish(names.back()));
    }
    TableColumns columns;
    // English words go first: those of other languages mean other things in English (data, temps).
    const auto find = [&](std::initializer_list<std::string_view> wanted)
    {
        const int column = columnOf(names, wanted);
        return column >= 0 ? column : columnOf(english, wanted);
    };
    columns.time = find({"time", "timestamp", "t", "datetime", "utc", "hhmmss", "hms", "tod", "ms", "millis",
                         "milliseconds"});
    columns.latitude = find({"latitude", "lat"});
    columns.longitude = find({"longitude", "lon", "lng", "long"});
    if (columns.latitude >= 0)
        columns.latitudeUnitDeg = unitOfDegrees(cells[static_cast<std::size_t>(columns.latitude)]);
    if (columns.longitude >= 0)
    {
        const auto at = static_cast<std::size_t>(columns.longitude);
        columns.longitudeUnitDeg = unitOfDegrees(cells[at]);
        columns.sideOfO = sideOfO(names[at]);
    }
    if (columns.latitude < 0 || columns.longitude < 0) columns.position = columnOf(names, {"position"});
    columns.isOfAircraft = columnOf(names, {"callsign", "icao", "squawk", "aircraft", "flight", "tail"}) >= 0;
    columns.ids = idColumns(cells);
    int rank = -1;
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        const bool isDate = names[i].front() == "date" || (english[i].front() == "date" && columns.date < 0);
        if (isDate && static_cast<int>(i) != columns.time) columns.date = static_cast<int>(i);
        const auto kind = heightKind(english[i]);
        if (!kind || kind->rank <= rank) continue;
        rank = kind->rank;
        columns.height = static_cast<int>(i);
        columns.datum = kind->datum;
    }
    for (const int column : {columns.time, columns.date})
    {
        if (column < 0) continue;
        const auto at = static_cast<std::size_t>(column);
        // Datum and data are English, too, and say other things there.
        if (names[at] != english[at] && !hasWord(names[at], {"datum", "data"})) columns.isDayFirst = true;
    }
    if (columns.time >= 0) columns.timeUnitS = timeUnit(english[static_cast<std::size_t>(columns.time)]);
    if (columns.height >= 0)
        columns.heightUnitM = heightUnit(english[static_cast<std::size_t>(columns.height)]);
    if (columns.heightUnitM == 1.0 && columns.position >= 0) columns.heightUnitM = foundation::kMetresPerFoot;
    if (columns.position >= 0 && rank == 3) columns.datum = HeightDatum::pressure; // of Flightradar24
    return columns;
}

} // namespace simulation
