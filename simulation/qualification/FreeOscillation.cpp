// SPDX-License-Identifier: Apache-2.0
#include "simulation/qualification/FreeOscillation.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace simulation
{

namespace
{

struct TurningPoint
{
    double timeS = 0.0, value = 0.0;
};

/// The turning points, between rows by a parabola through three.
std::vector<TurningPoint> turningPoints(const Flight& rows, FlightChannel channel)
{
    std::vector<TurningPoint> points;
    for (std::size_t i = 1; i + 1 < rows.size(); ++i)
    {
        const double before = rows[i - 1][channel], here = rows[i][channel], after = rows[i + 1][channel];
        if ((here - before) * (after - here) > 0.0 || here == before) continue;
        const double bend = before - 2.0 * here + after;
        const double shift = bend != 0.0 ? 0.5 * (before - after) / bend : 0.0;
        const double stepS = rows[i + 1][FlightChannel::time] - rows[i][FlightChannel::time];
        points.push_back(
            {rows[i][FlightChannel::time] + shift * stepS, here - 0.25 * (before - after) * shift});
    }
    return points;
}

} // namespace

std::optional<FreeOscillation> freeOscillation(const Flight& flight, FlightChannel channel,
                                               const FlightWindow& window)
{
    const std::vector<TurningPoint> points = turningPoints(rowsOf(flight, window), channel);
    if (points.size() < 4) return {};
    const std::size_t swings = points.size() - 1;
    const auto swing = [&](std::size_t i) { return std::abs(points[i + 1].value - points[i].value); };
    const double halves = static_cast<double>(swings);
    const double decrement = std::log(swing(0) / swing(swings - 1)) / (halves - 1.0);
    FreeOscillation oscillation;
    oscillation.periodS = 2.0 * (points.back().timeS - points.front().timeS) / halves;
    oscillation.damping = decrement / std::hypot(std::numbers::pi, decrement);
    return oscillation;
}

} // namespace simulation
