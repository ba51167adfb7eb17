// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec2.hpp>

#include "worldmaking/map/MapPlane.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// A runway between its two ends. Units: degrees east and north; metres.
struct Runway
{
    std::string airport, designators; ///< "LESU", "03/21"
    glm::dvec2 from{0.0}, to{0.0};
    double widthM = 30.0;
    std::string surface; ///< asphalt, gravel or grass
};

/// The runways of a table.
struct RunwayTable
{
    std::vector<Runway> runways;
    std::size_t unusable = 0;         ///< closed ones, and lines without both ends
    std::vector<std::string> notes{}; ///< what GDAL warned of, one line each
};

/// Reads runways of a table of OurAirports (comma-separated, a line of names first; ends, width in feet,
/// surface).
/// Errors: a file that cannot be read, or lacks one of the columns.
/// Source: ourairports.com/help/data-dictionary.html, runways.csv.
foundation::Result<RunwayTable> readRunways(const std::filesystem::path& file);

/// Returns the strip of a runway in the plane that stays free: kStripEndM beyond its ends, kStripSideM beside
/// it. Nothing: no place in the plane.
std::optional<PlanRings> stripOf(const Runway& runway, const MapPlane& plane);

inline constexpr double kStripEndM = 60.0, kStripSideM = 25.0;

} // namespace worldmaking
