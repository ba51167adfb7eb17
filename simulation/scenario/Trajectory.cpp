// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Trajectory.h"

#include <algorithm>
#include <array>

#include <foundation/SmallLetters.h>

namespace simulation
{

namespace
{

std::string smallExtensionOf(const std::filesystem::path& file)
{
    return foundation::inSmallLetters(file.extension().string());
}

} // namespace

bool namesTrackFile(const std::filesystem::path& file)
{
    static constexpr std::array<std::string_view, 6> kExtensions{".igc", ".gpx",  ".kml",
                                                                 ".kmz", ".acmi", ".csv"};
    const std::string last = smallExtensionOf(file);
    const std::string extension = last == ".gz" ? smallExtensionOf(file.stem()) : last;
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

bool TrajectoryPosition::operator==(const TrajectoryPosition& other) const
{
    return *trajectory == *other.trajectory && sM == other.sM && tM == other.tM &&
           orientation == other.orientation;
}

} // namespace simulation
