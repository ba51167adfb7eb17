// SPDX-License-Identifier: Apache-2.0
#include "worldtool/BuildReport.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace worldtool
{

namespace
{

/// "waysBeyondGround" in words.
std::string wordsOf(std::string_view key)
{
    std::string words;
    for (const char c : key)
    {
        if (std::isupper(static_cast<unsigned char>(c))) words += ' ';
        words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return words;
}

/// A count in words.
struct Count
{
    std::string text; ///< "412 streets", or "max grade 7.9 %" where the key ends with a unit
    double value = 0.0;
    bool isMeasure = false; ///< has a unit
};

Count countOf(std::string_view key, double value)
{
    constexpr std::array<std::pair<std::string_view, const char*>, 5> kUnits{
        {{"Km2", "km2"}, {"Km", "km"}, {"Ha", "ha"}, {"Percent", "%"}, {"M", "m"}}};
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%.*f", value == std::round(value) ? 0 : 1, value);
    for (const auto& [suffix, unit] : kUnits)
        if (key.ends_with(suffix))
            return {wordsOf(key.substr(0, key.size() - suffix.size())) + " " + number.data() + " " + unit,
                    value, true};
    return {std::string(number.data()) + " " + wordsOf(key), value, false};
}

/// What a row has that is not 0; of tags, which are many, the ten most frequent. Empty: it counts nothing.
std::string countsOf(const nlohmann::ordered_json& row)
{
    constexpr std::size_t kMostTags = 10;
    std::vector<Count> counts;
    bool areTags = false;
    for (const auto& [key, value] : row.items())
    {
        if (!value.is_number() || value.get<double>() == 0.0) continue;
        counts.push_back(countOf(key, value.get<double>()));
        areTags = areTags || key.find('=') != std::string::npos;
    }
    if (std::all_of(counts.begin(), counts.end(), [](const Count& count) { return count.isMeasure; }))
        return {};
    if (areTags)
        std::stable_sort(counts.begin(), counts.end(),
                         [](const Count& a, const Count& b) { return a.value > b.value; });
    const std::size_t told = areTags ? std::min(counts.size(), kMostTags) : counts.size();
    std::string text;
    for (std::size_t i = 0; i < told; ++i)
        text += (i == 0 ? "" : ", ") + counts[i].text;
    if (told < counts.size()) text += " and " + std::to_string(counts.size() - told) + " other tags";
    return text;
}

} // namespace

std::string summaryOf(const nlohmann::ordered_json& report)
{
    std::string lines;
    for (const auto& [part, row] : report.items())
    {
        if (part == "notes")
            for (const auto& note : row)
                lines += "note: " + note.get<std::string>() + '\n';
        if (!row.is_object()) continue;
        if (const std::string counts = countsOf(row); !counts.empty())
            lines += wordsOf(part) + ": " + counts + '\n';
    }
    return lines;
}

nlohmann::ordered_json rowOf(const worldmaking::StreetReport& report)
{
    return {{"ways", report.ways},
            {"closedWays", report.closedWays},
            {"waysBeyondGround", report.waysBeyondGround},
            {"shortWays", report.shortWays},
            {"missingNodes", report.missingNodes},
            {"streets", report.streets},
            {"crossings", report.crossings},
            {"turns", report.turns},
            {"bridges", report.bridges},
            {"tunnels", report.tunnels},
            {"overpasses", report.overpasses},
            {"lostOverpasses", report.lostOverpasses},
            {"overpassesLeftOpen", report.overpassesLeftOpen},
            {"impliedBridges", report.impliedBridges},
            {"coveredCrossings", report.coveredCrossings},
            {"levelCrossings", report.levelCrossings},
            {"bareTunnels", report.bareTunnels},
            {"sharpBends", report.sharpBends},
            {"litPlaces", report.litPlaces},
            {"trafficLights", report.trafficLights},
            {"waitSigns", report.waitSigns},
            {"roadsKm", report.lengthKm},
            {"maxGradePercent", report.steepestPercent},
            {"steepKm", report.steepKm}};
}

nlohmann::ordered_json rowOf(const worldmaking::HouseReport& report)
{
    return {{"read", report.read},
            {"standing", report.standing},
            {"towers", report.towers},
            {"cutBack", report.cutBack},
            {"passages", report.passages},
            {"parts", report.parts},
            {"onRoad", report.onRoad},
            {"overlapping", report.overlapping},
            {"onRunway", report.onRunway},
            {"inWater", report.inWater},
            {"underground", report.underground},
            {"beyondGround", report.beyondGround},
            {"unusable", report.unusable}};
}

nlohmann::ordered_json rowOf(const worldmaking::LandReport& report, std::size_t unusedRunways)
{
    return {{"coverAreas", report.coverAreas},
            {"fields", report.fields},
            {"waters", report.waters},
            {"waterLines", report.waterLines},
            {"ways", report.ways},
            {"railways", report.railways},
            {"aprons", report.aprons},
            {"runways", report.runways},
            {"unusedRunways", unusedRunways},
            {"untaggedWoodsHa", report.untaggedWoodsHa},
            {"gardensHa", report.gardensHa},
            {"yardsHa", report.yardsHa}};
}

nlohmann::ordered_json rowOf(const worldmaking::TreeReport& report)
{
    return {{"inWoods", report.inWoods},       {"single", report.single},    {"inRows", report.inRows},
            {"inOrchards", report.inOrchards}, {"hedges", report.hedges},    {"shrubs", report.shrubs},
            {"inGardens", report.inGardens},   {"spacingM", report.spacingM}};
}

nlohmann::ordered_json rowOf(const worldmaking::MadeUpReport& report)
{
    return {{"areaKm2", report.areaKm2},     {"settlements", report.settlements},
            {"unreached", report.unreached}, {"farms", report.farms},
            {"houses", report.houses},       {"fields", report.fields},
            {"hedges", report.hedges},       {"woods", report.woods},
            {"lakes", report.lakes},         {"bridges", report.bridges},
            {"roadsKm", report.roadsKm},     {"airfields", report.airfields}};
}

nlohmann::ordered_json rowOf(const worldmaking::WaterReport& report)
{
    return {{"lakes", report.lakes},
            {"rivers", report.rivers},
            {"unlevelled", report.unlevelled},
            {"beyondGround", report.beyondGround}};
}

nlohmann::ordered_json rowOf(const worldmaking::AirfieldReport& report)
{
    return {{"runways", report.runways},
            {"steepRunways", report.steepRunways},
            {"taxiways", report.taxiways},
            {"aprons", report.aprons},
            {"beyondGround", report.beyondGround}};
}

nlohmann::ordered_json rowOf(const worldmaking::StructureReport& report)
{
    return {{"walls", report.walls},
            {"fences", report.fences},
            {"powerLines", report.powerLines},
            {"railways", report.railways},
            {"turbines", report.turbines},
            {"windsocks", report.windsocks},
            {"footbridges", report.footbridges},
            {"streetLamps", report.streetLamps},
            {"litStreets", report.litStreets},
            {"unlitStreets", report.unlitStreets},
            {"cut", report.cut},
            {"beyondGround", report.beyondGround}};
}

} // namespace worldtool
