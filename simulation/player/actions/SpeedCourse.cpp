// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/actions/SpeedCourse.h"

#include <algorithm>
#include <cmath>

namespace simulation
{
namespace
{

constexpr double kShortestS = 1e-9;
constexpr double kNoJerkLimit = 1e9; ///< of the change of acceleration, m/s³

} // namespace

SpeedCourse::SpeedCourse(const SpeedProfileAction& action, double fromMps, double accelerationMps2,
                         double decelerationMps2)
{
    std::vector<Piece> lines;
    double time = 0.0;
    double speed = fromMps;
    const double highest = action.constraints.maxSpeedMps.value_or(1e9);
    for (const SpeedProfileAction::Entry& entry : action.entries)
    {
        const double target = std::min(entry.speedMps, highest);
        const double limit = target > speed
                                 ? action.constraints.maxAccelerationMps2.value_or(accelerationMps2)
                                 : action.constraints.maxDecelerationMps2.value_or(decelerationMps2);
        const double takes = entry.timeS   ? *entry.timeS
                             : limit > 0.0 ? std::fabs(target - speed) / limit
                                           : 0.0;
        if (takes > kShortestS) lines.push_back({time, speed, (target - speed) / takes, 0.0});
        time += std::max(takes, 0.0);
        speed = target;
    }
    lines.push_back({time, speed, 0.0, 0.0});
    if (action.isSmooth)
        addSmooth(lines, action.constraints);
    else
        _pieces = std::move(lines);
}

/// A parabola of the jerk j takes Δ = change of slope / j and touches line p (before) at τ and line n (after)
/// at τ + Δ: p(τ) + (slopes' mean)·Δ = n(τ + Δ).
void SpeedCourse::addSmooth(const std::vector<Piece>& lines, const DynamicConstraints& constraints)
{
    Piece line{0.0, lines.front().speedMps, 0.0, 0.0};
    _pieces.push_back(line);
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        const Piece& next = lines[i];
        const double bend = next.accelerationMps2 - line.accelerationMps2;
        if (std::fabs(bend) < kShortestS) continue;
        const double most = bend > 0.0 ? constraints.maxAccelerationRateMps3.value_or(kNoJerkLimit)
                                       : constraints.maxDecelerationRateMps3.value_or(kNoJerkLimit);
        const double takes = std::fabs(bend) / std::max(most, kShortestS);
        double start = 0.0;
        if (i > 0)
        {
            const double p = line.speedMps - line.accelerationMps2 * line.startS;
            const double n = next.speedMps - next.accelerationMps2 * next.startS;
            start = std::max((p - n - 0.5 * bend * takes) / bend, _pieces.back().startS);
        }
        const double speed = line.at(start);
        _pieces.push_back({start, speed, line.accelerationMps2, bend / takes});
        line = {start + takes, _pieces.back().at(start + takes), next.accelerationMps2, 0.0};
        _pieces.push_back(line);
    }
}

double SpeedCourse::speedAt(double timeS) const
{
    const auto after = std::upper_bound(_pieces.begin(), _pieces.end(), timeS,
                                        [](double time, const Piece& piece) { return time < piece.startS; });
    return after == _pieces.begin() ? _pieces.front().speedMps : std::prev(after)->at(timeS);
}

} // namespace simulation
