// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Earth.h>
namespace simulation
{

/// Pressure, temperature and density of air at rest.
struct AirState
{
    double pressurePa = 101325.0;
    double temperatureK = 288.15;
    double densityKgPerM3 = 1.225;
};

/// How the day differs from the standard.
struct AtmosphereOffsets
{
    double temperatureK = 0.0;       ///< added at every height
    double seaPressurePa = 101325.0; ///< at the height 0
};

constexpr double kGasConstant = 287.05287; ///< of dry air, J/(kg K)
constexpr double kSeaPressurePa = 101325.0;
constexpr double kSeaTemperatureK = 288.15;
constexpr double kSeaDensity = 1.225;

/// The standard atmosphere up to 20 km of geopotential height, with offsets of the day. Heights outside -2…20
/// km count as the nearest.
/// `heightM`: geometric, above the sea. Pressure follows the offset temperature hydrostatically.
/// Source: ICAO Doc 7488, *Manual of the ICAO Standard Atmosphere*, 3rd edition, 1993 (the troposphere and
/// the layer above it).
AirState standardAtmosphere(double heightM, const AtmosphereOffsets& offsets = {});

/// Calibrated airspeed of a true airspeed in given air: what a perfect instrument shows. Subsonic. Units:
/// m/s.
double calibratedAirspeed(double trueMps, const AirState& air);

/// The inverse of calibratedAirspeed().
double trueAirspeed(double calibratedMps, const AirState& air);

/// What an altimeter shows in air of a pressure when it is set to another: the height between the two in the
/// standard troposphere. Units: Pa, metres. Source: ICAO Doc 7488 (as standardAtmosphere()).
double altimeterHeight(double pressurePa, double settingPa);

/// The pressure at a geometric height above the sea, by what was reported for the sea (QNH): an altimeter
/// that is set to the report shows the geopotential height there. It does not depend on the day's
/// temperature. Up to 11 km. Units: metres, Pa. Source: ICAO Annex 3, *Meteorological Service for
/// International Air Navigation* (QNH), with the troposphere of Doc 7488.
double pressureByReport(double heightM, double reportedPa);

} // namespace simulation
