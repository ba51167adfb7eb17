// SPDX-License-Identifier: Apache-2.0
#include "TaxiwayStrokes.h"

#include <algorithm>
#include <cmath>

#include <foundation/NearestOnSegment.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kLineM = 0.15; ///< the middle line's width

/// A path whose bends are curves that stay on the pavement.
std::vector<glm::dvec2> withRoundBends(const std::vector<glm::dvec2>& path, double widthM)
{
    constexpr double kStraightRad = 0.1, kHairpinRad = 2.6, kPieceRad = 0.2;
    std::vector<glm::dvec2> round{path.front()};
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
        const glm::dvec2 before = path[i] - path[i - 1], after = path[i + 1] - path[i];
        const double shorterM = std::min(glm::length(before), glm::length(after));
        if (shorterM <= 0.0) continue;
        const glm::dvec2 from = glm::normalize(before), to = glm::normalize(after);
        const double bendRad = std::acos(std::clamp(glm::dot(from, to), -1.0, 1.0));
        if (bendRad < kStraightRad || bendRad > kHairpinRad)
        {
            round.push_back(path[i]);
            continue;
        }
        // The curve comes a quarter of `reachM` from both lines.
        const double reachM = std::min(1.25 * widthM * std::tan(0.5 * bendRad), 0.45 * shorterM);
        const int pieces = static_cast<int>(std::ceil(bendRad / kPieceRad));
        for (int piece = 0; piece <= pieces; ++piece)
        {
            const double share = static_cast<double>(piece) / pieces, rest = 1.0 - share;
            round.push_back(path[i] + reachM * (share * share * to - rest * rest * from));
        }
    }
    round.push_back(path.back());
    return round;
}

/// How far from a runway's centre line one waits.
double holdingM(const RunwayFrame& runway)
{
    const double lengthM = glm::distance(runway.a, runway.b);
    return lengthM < 800.0 ? 30.0 : lengthM < 1200.0 ? 40.0 : 75.0;
}

/// Places along a path, a metre apart.
std::vector<glm::dvec2> everyMetre(const std::vector<glm::dvec2>& path)
{
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
        const int pieces = std::max(1, static_cast<int>(std::lround(glm::distance(path[i], path[i + 1]))));
        for (int piece = 0; piece < pieces; ++piece)
            places.push_back(glm::mix(path[i], path[i + 1], static_cast<double>(piece) / pieces));
    }
    places.push_back(path.back());
    return places;
}

class TaxiwayPainter
{
public:
    explicit TaxiwayPainter(double widthM) : _widthM(widthM) {}

    std::vector<Stroke> strokes;

    void middleLine(const std::vector<glm::dvec2>& path)
    {
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            if (path[i] != path[i + 1]) yellow(path[i], path[i + 1], kLineM);
    }

    /// Wherever the places leave a runway, in their order.
    void holdingPositions(const std::vector<glm::dvec2>& places, const RunwayFrame& runway)
    {
        constexpr double kOnM = 3.0, kBeforeEndM = 12.0, kLeastClearM = 15.0;
        const double edgeM = 0.5 * runway.widthM, holdM = std::max(holdingM(runway), edgeM + kLeastClearM);
        const auto awayM = [&](std::size_t i)
        { return glm::distance(places[i], foundation::nearestOnSegment(places[i], runway.a, runway.b)); };
        for (std::size_t i = 1; i < places.size(); ++i)
        {
            if (awayM(i - 1) > edgeM + kOnM || awayM(i) <= edgeM + kOnM) continue;
            std::size_t at = i;
            while (at < places.size() && awayM(at) > edgeM + kOnM && awayM(at) < holdM)
                ++at;
            if (at == places.size())
            {
                at -= std::min(at, static_cast<std::size_t>(kBeforeEndM) + 1);
                if (at < i || awayM(at) < edgeM + kLeastClearM) continue;
            }
            if (awayM(at) > edgeM + kOnM)
                holdingPosition(places[at], glm::normalize(places[at] - places[at - 1]));
        }
    }

private:
    void yellow(const glm::dvec2& a, const glm::dvec2& b, double widthM)
    {
        strokes.push_back({a, b, 0.5 * widthM, FeatureCells::yellow});
    }

    /// `away`: from the runway.
    void holdingPosition(const glm::dvec2& place, const glm::dvec2& away)
    {
        constexpr double kWideM = 0.3, kDashM = 0.9;
        const glm::dvec2 across(away.y, -away.x);
        const double halfM = 0.5 * _widthM;
        for (const double aheadM : {3.0 * kWideM, kWideM})
            yellow(place + aheadM * away - halfM * across, place + aheadM * away + halfM * across, kWideM);
        for (const double aheadM : {-kWideM, -3.0 * kWideM})
            for (double side = -halfM; side + kDashM <= halfM + 1e-9; side += 2.0 * kDashM)
                yellow(place + aheadM * away + side * across,
                       place + aheadM * away + (side + kDashM) * across, kWideM);
    }

    double _widthM;
};

} // namespace

std::vector<Stroke> taxiwayStrokes(const std::vector<glm::dvec2>& path, double widthM,
                                   std::span<const RunwayFrame> runways)
{
    if (path.size() < 2) return {};
    TaxiwayPainter painter(widthM);
    painter.middleLine(withRoundBends(path, widthM));
    std::vector<glm::dvec2> places = everyMetre(path);
    for (int way = 0; way < 2; ++way)
    {
        for (const RunwayFrame& runway : runways)
            painter.holdingPositions(places, runway);
        std::reverse(places.begin(), places.end());
    }
    return std::move(painter.strokes);
}

} // namespace osgTerrainROAM::core
