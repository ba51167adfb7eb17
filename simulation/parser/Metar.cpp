// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/Metar.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include <foundation/Angle.h>
#include <foundation/LineCells.h>
#include <foundation/Units.h>

namespace simulation
{
namespace
{

constexpr double kPascalPerInch = 3386.389, kMetresPerMile = 1609.344;

bool areDigits(std::string_view text)
{
    return !text.empty() &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

int numberOf(std::string_view digits)
{
    int value = 0;
    for (const char digit : digits)
        value = 10 * value + (digit - '0');
    return value;
}

/// 24012G20KT, VRB02KT, 09004MPS. A wind from no direction blows from the north.
bool readWind(std::string_view cell, Weather& weather)
{
    const bool inKnots = cell.ends_with("KT"), inMetres = cell.ends_with("MPS");
    if (!inKnots && !inMetres) return false;
    const std::string_view from = cell.substr(0, 3);
    std::string_view speed = cell.substr(std::min<std::size_t>(3, cell.size()));
    speed = speed.substr(0, speed.find_first_not_of("0123456789"));
    if ((from != "VRB" && !areDigits(from)) || speed.size() < 2 || speed.size() > 3) return false;
    const double blowsToDeg = (from == "VRB" ? 0.0 : numberOf(from)) + 180.0; // clockwise from north
    weather.wind = Wind{foundation::radiansOf(90.0 - blowsToDeg),
                        numberOf(speed) * (inKnots ? foundation::kMpsPerKnot : 1.0)};
    return true;
}

/// 0800, 9999, 10SM, 1/2SM, CAVOK. 10 km and more say nothing of how much more.
bool readVisibility(std::string_view cell, Weather& weather)
{
    constexpr double kOpenM = 9999.0;
    double metres = 0.0;
    if (cell == "CAVOK") return true;
    if (cell.size() == 4 && areDigits(cell))
        metres = numberOf(cell);
    else if (cell.ends_with("SM"))
    {
        cell.remove_suffix(2);
        const std::size_t bar = cell.find('/');
        const std::string_view above = cell.substr(0, bar);
        if (!areDigits(above)) return false;
        metres = numberOf(above) * kMetresPerMile;
        if (bar != std::string_view::npos)
        {
            const std::string_view below = cell.substr(bar + 1);
            if (!areDigits(below) || numberOf(below) == 0) return false;
            metres /= numberOf(below);
        }
    }
    else
        return false;
    if (metres < kOpenM) weather.fogVisualRangeM = std::max(metres, 50.0);
    return true;
}

CloudLayer layerOf(int oktas, double baseM, std::string_view tower)
{
    constexpr double kIceM = 6000.0, kHeapsM = 3000.0, kSheetM = 2000.0, kTopM = 19000.0;
    CloudLayer layer{CloudKind::stratocumulus, oktas, std::min(baseM, kTopM), 0.0};
    double thicknessM = 450.0;
    if (tower == "CB" || tower == "TCU")
        layer.kind = CloudKind::cumulus, thicknessM = tower == "CB" ? 6000.0 : 3000.0;
    else if (baseM >= kIceM)
        layer.kind = CloudKind::cirrus;
    else if (oktas <= 4 && baseM < kHeapsM)
        layer.kind = CloudKind::cumulus, thicknessM = 850.0;
    else if (oktas >= 8 && baseM < kSheetM)
        layer.kind = CloudKind::stratus, thicknessM = 700.0;
    layer.topM = std::min(layer.baseM + thicknessM, 20000.0);
    return layer;
}

/// FEW040, SCT025TCU, BKN///, OVC008, VV002.
bool readClouds(std::string_view cell, std::vector<CloudLayer>& layers)
{
    if (cell == "NSC" || cell == "NCD" || cell == "SKC" || cell == "CLR") return true;
    const std::string_view word = cell.substr(0, cell.starts_with("VV") ? 2 : 3);
    const int oktas = word == "FEW"                   ? 2
                      : word == "SCT"                 ? 4
                      : word == "BKN"                 ? 6
                      : word == "OVC" || word == "VV" ? 8
                                                      : 0;
    if (oktas == 0 || cell.size() < word.size() + 3) return false;
    const std::string_view height = cell.substr(word.size(), 3);
    if (height == "///") return true;
    if (!areDigits(height)) return false;
    layers.push_back(
        layerOf(oktas, 100.0 * numberOf(height) * foundation::kMetresPerFoot, cell.substr(word.size() + 3)));
    return true;
}

/// -RA, SHRA, +TSRAGR, SN, DZ, RASN, FZDZ, GS, PL. Of several the one that comes first in the table counts.
bool readFall(std::string_view cell, Weather& weather)
{
    struct Kind
    {
        std::string_view code, type;
        double mmPerHour; ///< moderate
    };
    static constexpr std::array<Kind, 9> kFalls{{{"SN", "snow", 1.5},
                                                 {"SG", "snow", 0.5},
                                                 {"IC", "snow", 0.1},
                                                 {"GR", "rain", 15.0},
                                                 {"RA", "rain", 4.0},
                                                 {"PL", "rain", 2.0},
                                                 {"GS", "rain", 2.0},
                                                 {"UP", "rain", 2.0},
                                                 {"DZ", "rain", 0.5}}};
    const bool isLight = cell.starts_with('-'), isHeavy = cell.starts_with('+');
    if (isLight || isHeavy) cell.remove_prefix(1);
    if (cell.starts_with("SH") || cell.starts_with("TS") || cell.starts_with("FZ")) cell.remove_prefix(2);
    if (cell.empty() || cell.size() > 6 || cell.size() % 2 != 0) return false;
    const Kind* falls = kFalls.end();
    for (std::size_t at = 0; at < cell.size(); at += 2)
    {
        const Kind* const kind = std::find_if(kFalls.begin(), kFalls.end(),
                                              [&](const Kind& k) { return k.code == cell.substr(at, 2); });
        if (kind == kFalls.end()) return false;
        falls = std::min(falls, kind);
    }
    weather.precipitation =
        Precipitation{std::string(falls->type), falls->mmPerHour * (isLight ? 0.35 : (isHeavy ? 3.0 : 1.0))};
    return true;
}

/// 12/08, M02/M05.
bool readTemperature(std::string_view cell, Weather& weather)
{
    const std::size_t bar = cell.find('/');
    if (bar == std::string_view::npos) return false;
    std::string_view air = cell.substr(0, bar);
    const bool isBelow = air.starts_with('M');
    if (isBelow) air.remove_prefix(1);
    if (air.size() != 2 || !areDigits(air)) return false;
    weather.temperatureK = foundation::kZeroCelsiusK + (isBelow ? -1.0 : 1.0) * numberOf(air);
    return true;
}

/// Q1013, A2992.
bool readPressure(std::string_view cell, Weather& weather)
{
    if (cell.size() != 5 || !areDigits(cell.substr(1))) return false;
    if (cell[0] == 'Q')
        weather.seaPressurePa = 100.0 * numberOf(cell.substr(1));
    else if (cell[0] == 'A')
        weather.seaPressurePa = 0.01 * kPascalPerInch * numberOf(cell.substr(1));
    else
        return false;
    return true;
}

/// Sorts layers; those that begin in another one's heights cut its top, or are left out.
std::vector<CloudLayer> sorted(std::vector<CloudLayer> layers)
{
    constexpr double kApartM = 50.0;
    std::stable_sort(layers.begin(), layers.end(),
                     [](const CloudLayer& a, const CloudLayer& b) { return a.baseM < b.baseM; });
    std::vector<CloudLayer> kept;
    for (const CloudLayer& layer : layers)
    {
        if (kept.size() == kMostCloudLayers) break;
        if (!kept.empty() && layer.baseM < kept.back().baseM + kApartM) continue;
        if (!kept.empty()) kept.back().topM = std::min(kept.back().topM, layer.baseM);
        kept.push_back(layer);
    }
    return kept;
}

} // namespace

foundation::Result<Metar> readMetar(std::string_view text, std::string_view place)
{
    Metar report;
    std::vector<CloudLayer> layers;
    int known = 0;
    for (std::string_view cell : foundation::lineCells(text))
    {
        if (cell == "RMK" || cell == "TEMPO" || cell == "BECMG" || cell == "NOSIG" || cell == "=") break;
        if (cell.ends_with('=')) cell.remove_suffix(1);
        if (readWind(cell, report.weather) || readVisibility(cell, report.weather) ||
            readClouds(cell, layers) || readFall(cell, report.weather) ||
            readTemperature(cell, report.weather) || readPressure(cell, report.weather))
            ++known;
    }
    if (known == 0)
        return foundation::Error{std::string(place), "'" + std::string(text) + "' tells no weather",
                                 "write a METAR, as in LOWI 241150Z 25012KT 9999 FEW040 SCT080 18/09 Q1018"};
    report.clouds = sorted(std::move(layers));
    return report;
}

} // namespace simulation
