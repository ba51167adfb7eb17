// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/Sweep.h"

#include <glm/geometric.hpp>

#include "scenery/models/roads/SignAtlas.h"

namespace scenery::models
{

void addSweep(ModelBuilder& builder, const std::vector<SweepStation>& stations, double uvPerM)
{
    const std::size_t points = stations.front().profile.size();
    const SignCell plain = cellOf(SignFace::plain);
    std::vector<double> along(stations.size(), 0.0), around(points + 1, 0.0);
    for (std::size_t k = 1; k < stations.size(); ++k)
        along[k] = along[k - 1] + glm::distance(stations[k].at, stations[k - 1].at);
    for (std::size_t i = 0; i < points; ++i)
        around[i + 1] =
            around[i] + glm::distance(stations[0].profile[i], stations[0].profile[(i + 1) % points]);
    const auto corner = [&](std::size_t k, std::size_t i)
    {
        const SweepStation& station = stations[k];
        const glm::dvec2 offset = station.profile[i % points];
        const glm::vec2 uv =
            uvPerM > 0.0 ? glm::vec2(uvPerM * along[k], uvPerM * around[i]) : 0.5F * (plain.low + plain.high);
        return Corner{station.at + glm::dvec3(offset.x * station.left.x, offset.x * station.left.y, offset.y),
                      uv};
    };
    for (std::size_t k = 0; k + 1 < stations.size(); ++k)
        for (std::size_t i = 0; i < points; ++i)
            builder.quad(corner(k, i), corner(k, i + 1), corner(k + 1, i + 1), corner(k + 1, i));
    const std::size_t last = stations.size() - 1;
    for (std::size_t i = 0; i + 1 < points / 2; ++i)
    {
        builder.quad(corner(last, i), corner(last, i + 1), corner(last, points - 2 - i),
                     corner(last, points - 1 - i));
        builder.quad(corner(0, points - 1 - i), corner(0, points - 2 - i), corner(0, i + 1), corner(0, i));
    }
}

} // namespace scenery::models
