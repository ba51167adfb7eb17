// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/WingPanel.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr int kChordSteps = 9; ///< along the chord

/// Half the thickness at a share of the chord, over chord and thickness. The last coefficient closes the
/// trailing edge.
double aerofoilHalf(double c)
{
    return 5.0 * (0.2969 * std::sqrt(c) - 0.1260 * c - 0.3516 * c * c + 0.2843 * c * c * c -
                  0.1036 * c * c * c * c);
}

/// The corners around a panel at one station: over the upper side to the front, over the lower one back.
std::vector<Corner> aerofoilRing(const AerofoilStation& station, const WingPanel& panel, const glm::dvec3& up)
{
    std::vector<Corner> ring;
    for (const double side : {1.0, -1.0})
        for (int i = 0; i <= kChordSteps; ++i)
        {
            const double step = static_cast<double>(side > 0.0 ? kChordSteps - i : i) / kChordSteps;
            const double eased =
                panel.fromShare > 0.0 ? step : 0.5 * (1.0 - std::cos(std::numbers::pi * step));
            const double c = panel.fromShare + (panel.toShare - panel.fromShare) * eased;
            const double half = side * aerofoilHalf(c) * station.thickness * station.chordM;
            ring.push_back({chordPoint(station, c) + up * half, plainUv()});
        }
    ring.push_back(ring.front());
    return ring;
}

} // namespace

std::vector<AerofoilStation> mirrored(std::vector<AerofoilStation> stations)
{
    for (AerofoilStation& station : stations)
        station.leadingEdge.y = -station.leadingEdge.y;
    return stations;
}

void addWingPanel(ModelBuilder& builder, const WingPanel& panel)
{
    glm::dvec3 along = panel.stations.back().leadingEdge - panel.stations.front().leadingEdge;
    along.x = 0.0;
    const glm::dvec3 up = glm::normalize(glm::cross(glm::dvec3(1.0, 0.0, 0.0), along));
    const double middle = 0.5 * (panel.fromShare + panel.toShare);
    const auto capAt = [&](const AerofoilStation& station) {
        return std::vector<Corner>(2 * kChordSteps + 3, Corner{chordPoint(station, middle), plainUv()});
    };
    std::vector<std::vector<Corner>> rows{capAt(panel.stations.front())};
    for (const AerofoilStation& station : panel.stations)
        rows.push_back(aerofoilRing(station, panel, up));
    rows.push_back(capAt(panel.stations.back()));
    builder.grid(rows);
}

} // namespace scenery::models
