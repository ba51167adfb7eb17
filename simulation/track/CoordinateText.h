// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace simulation
{

/// Which side the letter O is: Ost and oost are east, ouest, oeste and ovest west.
enum class SideOfO
{
    unknown,
    east,
    west
};

/// How coordinates of a table are written.
struct CoordinateStyle
{
    double unitDeg = 1.0; ///< of a whole number: 1e-7, where the heading says so
    SideOfO sideOfO = SideOfO::unknown;
};

/// A coordinate, or what stands against it.
struct CoordinateReading
{
    std::optional<double> degrees;
    std::string fault; ///< empty: none, or it is no number
};

/// Reads a coordinate: 51.4778, 51,4778, 48.5N, 51°28'40.1"N, 51 28.668N, 51:28:40, N51-28-40. Units:
/// degrees, north and east. `isEast`: of a longitude. Refused are minutes and seconds from 60 on or behind a
/// part of a degree, a sign beside a letter, a letter of the other axis, and O where nobody says which side
/// it is.
CoordinateReading readCoordinate(std::string_view cell, bool isEast, const CoordinateStyle& style);

} // namespace simulation
