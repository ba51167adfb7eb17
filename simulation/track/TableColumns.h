// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "simulation/track/CoordinateText.h"
#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// What the columns of a table of positions hold, by their names.
struct TableColumns
{
    static constexpr int kNone = -1;

    int date = kNone, time = kNone, latitude = kNone, longitude = kNone, height = kNone;
    int position = kNone; ///< latitude and longitude in one cell, where they have none of their own
    double latitudeUnitDeg = 1.0, longitudeUnitDeg = 1.0; ///< 1e-7 or 1e-6 where the name says so
    SideOfO sideOfO = SideOfO::unknown;                   ///< by the language of the longitude's name
    bool isDayFirst = false;  ///< of 03/04/2026: as where the names of time and date are not English
    double timeUnitS = 1.0;   ///< of a time that is a small number
    double heightUnitM = 1.0; ///< feet, cm or mm where the name says so; feet beside a position in one cell
    HeightDatum datum = HeightDatum::meanSeaLevel;
    bool isOfAircraft = false; ///< a column names the aircraft
    std::vector<int> ids{};    ///< that may tell which object a row is of, the surest first

    bool havePlace() const { return position >= 0 || (latitude >= 0 && longitude >= 0); }
};

/// Finds the columns: by the first word of a name, else by another (`gps_latitude`, `baroAltitude`), in
/// English or in the languages of inEnglish(). Of several heights that above the sea or the ellipsoid is
/// taken, before one that does not say so, before pressure altitudes, before those above the ground.
TableColumns columnsOf(const std::vector<std::string>& names);

} // namespace simulation
