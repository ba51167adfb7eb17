// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/SpeedTags.h"

#include <algorithm>
#include <array>
#include <string>

#include <foundation/TagQuantity.h>

namespace worldmaking
{

namespace
{

constexpr double kWalkKmh = 5.0, kAdvisedKmh = 130.0;
constexpr double kMph = foundation::kMpsPerMph * foundation::kKmhPerMps;

/// The limits of a country outside towns, km/h. `urban`: where it is not 50.
struct CountryLimits
{
    std::string_view code;
    double rural, trunk, motorway, urban = 50.0;
};

constexpr std::array kCountries = std::to_array<CountryLimits>({
    {"at", 100, 100, 130},
    {"au", 100, 100, 110},
    {"be", 90, 120, 120},
    {"be-bru", 70, 120, 120, 30},
    {"be-vlg", 70, 120, 120},
    {"be-wal", 90, 120, 120},
    {"bg", 90, 120, 140},
    {"by", 90, 90, 110, 60},
    {"ca", 80, 100, 110},
    {"ch", 80, 100, 120},
    {"cz", 90, 110, 130},
    {"de", 100, 100, 130},
    {"dk", 80, 80, 130},
    {"ee", 90, 90, 110},
    {"es", 90, 90, 120},
    {"fi", 80, 100, 120},
    {"fr", 80, 110, 130},
    {"gr", 90, 110, 130},
    {"hr", 90, 110, 130},
    {"hu", 90, 110, 130},
    {"ie", 80, 100, 120},
    {"it", 90, 110, 130},
    {"jp", 60, 60, 100},
    {"kz", 90, 110, 140, 60},
    {"lt", 90, 120, 130},
    {"lv", 90, 90, 110},
    {"md", 90, 90, 110},
    {"nl", 80, 100, 100},
    {"no", 80, 90, 110},
    {"nz", 100, 100, 110},
    {"pl", 90, 100, 140},
    {"pt", 90, 100, 120},
    {"ro", 90, 100, 130},
    {"rs", 80, 100, 130},
    {"ru", 90, 90, 110, 60},
    {"se", 70, 90, 110},
    {"si", 90, 110, 130},
    {"sk", 90, 90, 130},
    {"tr", 90, 110, 130},
    {"ua", 90, 110, 130},
    {"uk", 60 * kMph, 70 * kMph, 70 * kMph, 30 * kMph},
    {"gb", 60 * kMph, 70 * kMph, 70 * kMph, 30 * kMph},
    {"us", 55 * kMph, 55 * kMph, 65 * kMph, 25 * kMph},
    {"uz", 100, 100, 100, 70},
    {"za", 100, 120, 120, 60},
});
constexpr CountryLimits kDefault{"", 90, 100, 120};

std::string lowerOf(std::string_view text)
{
    std::string lower;
    for (const char c : text)
        if (c != ' ') lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

std::optional<double> limitOf(const CountryLimits& limits, std::string_view zone)
{
    for (const std::string_view word : {"zone:", "zone"})
        if (zone.starts_with(word)) return foundation::kmhOfTag(zone.substr(word.size()));
    if (zone == "urban" || zone == "nsl_restricted" || zone == "city" || zone == "urban_primary" ||
        zone == "urban_secondary")
        return limits.urban;
    if (zone == "rural" || zone == "nsl_single" || zone == "national") return limits.rural;
    if (zone == "trunk" || zone == "expressway" || zone == "express" || zone == "nsl_dual")
        return limits.trunk;
    if (zone == "motorway" || zone == "freeway") return limits.motorway;
    if (zone == "urban_motorway") return std::min(limits.motorway, 80.0);
    if (zone == "living_street") return limits.code == "de" ? kWalkKmh : 20.0;
    if (zone == "school") return 30.0;
    if (zone == "bicycle_road" || zone == "cyclestreet") return 30.0;
    if (zone == "pedestrian_zone" || zone == "walk") return kWalkKmh;
    return foundation::kmhOfTag(zone); // "DE:30"
}

std::optional<double> speedOfWord(const std::string& word)
{
    if (word == "walk" || word == "walking") return kWalkKmh;
    if (word == "none" || word == "unlimited" || word == "nolimit") return kAdvisedKmh;
    const std::size_t colon = word.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const std::string_view code = std::string_view(word).substr(0, colon),
                           zone = std::string_view(word).substr(colon + 1);
    if (code == "sign" || code == "zone") return foundation::kmhOfTag(zone);
    const auto found = std::find_if(kCountries.begin(), kCountries.end(),
                                    [&](const CountryLimits& limits) { return limits.code == code; });
    return limitOf(found == kCountries.end() ? kDefault : *found, zone);
}

} // namespace

std::optional<double> speedKmhOf(std::string_view text)
{
    constexpr double kLeast = 3.0, kMost = 200.0;
    auto speed = foundation::kmhOfTag(text);
    if (!speed)
    {
        const std::string word = lowerOf(text);
        speed = speedOfWord(word.substr(0, word.find(';')));
    }
    return speed && *speed >= kLeast && *speed <= kMost ? speed : std::nullopt;
}

} // namespace worldmaking
