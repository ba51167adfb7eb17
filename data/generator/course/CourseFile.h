// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "course/Alignment.h"
#include "course/CourseProfile.h"

namespace islandgen
{

/// Writes a course as a road network in ASAM OpenDRIVE 1.7: four country roads, one behind the other, with
/// two lanes of 3.5 m and shoulders of 1 m, superelevation in the bends, marks, delineator posts, guard rails
/// above embankments, and signs. Coordinates are metres from the terrain's middle; the offset in the header
/// makes them those of UTM zone 32 north. Heights are above mean sea level.
/// Errors: folder missing or not writable, no space.
foundation::Outcome writeCourse(const Terrain& terrain, const Alignment& alignment,
                                const CourseHeights& heights, const std::filesystem::path& file);

} // namespace islandgen
