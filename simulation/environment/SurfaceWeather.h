// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace simulation
{

/// What weather has left on the ground at the scene's origin.
struct SurfaceWeather
{
    double waterMm = 0.0; ///< film on level sealed ground
    double snowCm = 0.0;  ///< that lies on level ground
    bool isIcy = false;   ///< the water is frozen
    bool areRoadsCleared = false;

    bool operator==(const SurfaceWeather&) const = default;
};

/// A road is wet to tyres from this film on. Units: mm.
inline constexpr double kLeastFilmMm = 0.02;

/// Snow that is thinner changes nothing under tyres. Units: cm.
inline constexpr double kLeastSnowCm = 0.3;

/// Reads what lies on the ground, parts parted by ';': "dry", "moist" (0.1 mm), "wet" (0.5 mm), "puddles"
/// (2 mm), "water MM", "ice" (0.5 mm unless water is told), "snow CM", "cleared" (roads have no snow).
/// Errors: a word that is none of these, a number out of range. `place`: for messages.
foundation::Result<SurfaceWeather> readSurfaceWeather(std::string_view text, std::string_view place);

/// Returns the text that readSurfaceWeather() reads it from, to the last digit.
std::string textOf(const SurfaceWeather& ground);

/// Returns the film that a wetness of roads in ASAM OpenSCENARIO 1.3 means, "moist" to "highFlooded"; 0 for
/// any other word. The standard gives no depths; 20 and 100 mm for floods are chosen. Units: mm.
double filmOfRoads(std::string_view wetness);

/// Returns how wet a film makes sealed ground look, 0 … 1: 0.5 at 0.1 mm, 0.8 at 0.5 mm, where the hollows
/// of the texture are full, 1 from 2 mm on, with puddles. Linear between these.
double wetnessOf(double waterMm);

/// What falls, as the ground gets it.
struct Fall
{
    double rainMmPerHour = 0.0, snowMmPerHour = 0.0; ///< both as water
    double temperatureC = 0.0;                       ///< of the air; melts snow above 0
    bool isMelting = false;                          ///< the temperature is known
};

/// Returns what is left after `durationS` of an even fall.
/// Water: up to the depth of the texture, 0.5 mm, it stays; what is above flows off, by a linear reservoir
/// with a residence time of 70 s, so that 10 mm/h leave 0.2 mm above it and 50 mm/h 1 mm: the size of what
/// Gallaway, Schiller and Rose, *Effects of rainfall intensity, pavement cross slope, surface texture, and
/// drainage length on pavement water depths* (1971), measured on lanes. When nothing falls 0.25 mm an hour
/// evaporate: a summer's day has some 4 mm in daylight (Allen, Pereira, Raes and Smith, *Crop
/// evapotranspiration*, FAO 56, 1998, table 2).
/// Snow: fresh snow has a tenth of the density of water (Judson and Doesken, *Density of freshly fallen snow
/// in the central Rocky Mountains*, 2000), so 1 mm as water is 1 cm. Above 0 °C 4.5 mm of water melt a day
/// and degree (Hock, *Temperature index melt modelling in mountain areas*, 2003, table 1: 1.6 … 11.6), and
/// wet the ground.
SurfaceWeather weathered(const SurfaceWeather& before, const Fall& fall, double durationS);

} // namespace simulation
