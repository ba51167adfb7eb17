// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/SurfaceWeather.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <foundation/LineCells.h>

namespace simulation
{
namespace
{

constexpr double kMoistMm = 0.1, kTextureMm = 0.5, kPuddlesMm = 2.0;
constexpr double kMostWaterMm = 100.0, kMostSnowCm = 300.0;
constexpr double kSurfaceHourS = 3600.0;

std::optional<double> amountIn(std::string_view cell, double most)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !(value >= 0.0 && value <= most))
        return std::nullopt;
    return value;
}

/// Applies a part such as "snow 5 cleared". Returns whether all of it is understood.
bool applyPart(std::string_view text, SurfaceWeather& ground, bool& isWaterTold)
{
    static constexpr std::array<std::pair<std::string_view, double>, 4> kFilms{
        {{"dry", 0.0}, {"moist", kMoistMm}, {"wet", kTextureMm}, {"puddles", kPuddlesMm}}};
    const auto cells = foundation::lineCells(text);
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
        const auto film = std::find_if(kFilms.begin(), kFilms.end(),
                                       [&](const auto& known) { return known.first == cells[i]; });
        if (film != kFilms.end())
            ground.waterMm = film->second, isWaterTold = true;
        else if (cells[i] == "ice")
            ground.isIcy = true;
        else if (cells[i] == "cleared")
            ground.areRoadsCleared = true;
        else if (cells[i] == "water" || cells[i] == "snow")
        {
            const bool isSnow = cells[i] == "snow";
            if (++i == cells.size()) return false;
            const auto amount = amountIn(cells[i], isSnow ? kMostSnowCm : kMostWaterMm);
            if (!amount) return false;
            (isSnow ? ground.snowCm : ground.waterMm) = *amount;
            isWaterTold = isWaterTold || !isSnow;
        }
        else
            return false;
    }
    return !cells.empty();
}

std::string shortest(double value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

/// The film after an even supply of water. Units: mm, hours.
double filmAfter(double beforeMm, double mmPerHour, double hours)
{
    constexpr double kStaysHours = 70.0 / kSurfaceHourS, kDriesMmPerHour = 0.25;
    const double gain = mmPerHour > 0.0 ? mmPerHour : -kDriesMmPerHour;
    const double level = kTextureMm + gain * kStaysHours; // that the film tends to above the texture
    if (beforeMm < kTextureMm)
    {
        if (gain <= 0.0) return std::max(beforeMm + gain * hours, 0.0);
        const double full = (kTextureMm - beforeMm) / gain;
        if (hours <= full) return beforeMm + gain * hours;
        return level + (kTextureMm - level) * std::exp(-(hours - full) / kStaysHours);
    }
    if (gain > 0.0) return level + (beforeMm - level) * std::exp(-hours / kStaysHours);
    const double drained = kStaysHours * std::log((beforeMm - level) / (kTextureMm - level));
    if (hours <= drained) return level + (beforeMm - level) * std::exp(-hours / kStaysHours);
    return std::max(kTextureMm + gain * (hours - drained), 0.0);
}

} // namespace

foundation::Result<SurfaceWeather> readSurfaceWeather(std::string_view text, std::string_view place)
{
    SurfaceWeather ground;
    bool isWaterTold = false;
    for (std::size_t at = 0; at <= text.size();)
    {
        const std::size_t end = std::min(text.find(';', at), text.size());
        const std::string_view part = text.substr(at, end - at);
        if (!applyPart(part, ground, isWaterTold))
            return foundation::Error{
                std::string(place), "'" + std::string(part) + "' is nothing on the ground",
                "write dry, moist, wet, puddles, water MM (0 to 100), ice, snow CM (0 to "
                "300) or cleared, parted by ';', as in snow 5; cleared"};
        at = end + 1;
    }
    if (ground.isIcy && !isWaterTold) ground.waterMm = kTextureMm;
    return ground;
}

std::string textOf(const SurfaceWeather& ground)
{
    std::string text = "water " + shortest(ground.waterMm) + "; snow " + shortest(ground.snowCm);
    if (ground.isIcy) text += "; ice";
    if (ground.areRoadsCleared) text += "; cleared";
    return text;
}

double filmOfRoads(std::string_view wetness)
{
    static constexpr std::array<std::pair<std::string_view, double>, 4> kFilms{
        {{"moist", kMoistMm}, {"wetWithPuddles", kPuddlesMm}, {"lowFlooded", 20.0}, {"highFlooded", 100.0}}};
    const auto film =
        std::find_if(kFilms.begin(), kFilms.end(), [&](const auto& known) { return known.first == wetness; });
    return film == kFilms.end() ? 0.0 : film->second;
}

double wetnessOf(double waterMm)
{
    constexpr double kMoist = 0.5, kWet = 0.8;
    if (waterMm <= 0.0) return 0.0;
    if (waterMm < kMoistMm) return kMoist * waterMm / kMoistMm;
    if (waterMm < kTextureMm) return std::lerp(kMoist, kWet, (waterMm - kMoistMm) / (kTextureMm - kMoistMm));
    return std::lerp(kWet, 1.0, std::min((waterMm - kTextureMm) / (kPuddlesMm - kTextureMm), 1.0));
}

SurfaceWeather weathered(const SurfaceWeather& before, const Fall& fall, double durationS)
{
    constexpr double kMeltsMmPerHour = 4.5 / 24.0, kCmPerMm = 1.0; // a degree; of fresh snow
    const double hours = std::max(durationS, 0.0) / kSurfaceHourS;
    SurfaceWeather after = before;
    const double warmth = fall.isMelting ? std::max(fall.temperatureC, 0.0) : 0.0;
    const double melts = kMeltsMmPerHour * warmth;
    const double gain = kCmPerMm * (fall.snowMmPerHour - melts);
    after.snowCm = std::max(before.snowCm + gain * hours, 0.0);
    const bool hasSnow = before.snowCm > 0.0 || fall.snowMmPerHour > 0.0;
    const double meltMmPerHour =
        hasSnow ? std::min(melts, fall.snowMmPerHour + before.snowCm / kCmPerMm / std::max(hours, 1e-9))
                : 0.0;
    after.waterMm = filmAfter(before.waterMm, fall.rainMmPerHour + meltMmPerHour, hours);
    return after;
}

} // namespace simulation
