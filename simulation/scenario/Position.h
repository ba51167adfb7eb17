// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "simulation/scenario/SourceLine.h"

namespace simulation
{

/// Angles as in OpenSCENARIO; a missing angle follows from the path or the ground.
/// Frame: ISO 8855 about the axes of the scene. Heading counter-clockwise from east, pitch positive nose down, roll
/// positive right side down. Units: radians, as in the file.
struct Orientation
{
    std::optional<double> headingRad;
    std::optional<double> pitchRad;
    std::optional<double> rollRad;

    bool operator==(const Orientation&) const = default;
};

/// Frame: east-north-up about the scene's origin. Units: metres.
/// A missing z means: on the ground, where the player knows one, else 0.
struct WorldPosition
{
    SourceLine source;
    double xM = 0.0;
    double yM = 0.0;
    std::optional<double> zM;
    Orientation orientation;

    bool operator==(const WorldPosition&) const = default;
};

/// WGS84. The file's `latitude` and `longitude` (1.1) are radians, `latitudeDeg` and `longitudeDeg` (1.2)
/// degrees; the model keeps degrees.
/// `height` (1.0, 1.1; deprecated from 1.2 on) is "above a reference surface (e.g. sea level, earth surface)", here the
/// ellipsoid; `altitude` (from 1.2 on) is above the road surface, here the ground. Neither: on the ground. Source: ASAM OpenSCENARIO XML 1.1 and 1.3, class
/// GeoPosition.
struct GeoPosition
{
    SourceLine source;
    double latitudeDeg = 0.0;
    double longitudeDeg = 0.0;
    std::optional<double> heightM;   ///< above the ellipsoid
    std::optional<double> altitudeM; ///< above the ground; heightM wins where both stand
    Orientation orientation;         ///< about the scene's axes, as for WorldPosition

    bool operator==(const GeoPosition&) const = default;
};

using Position = std::variant<WorldPosition, GeoPosition, Unsupported>;

} // namespace simulation
