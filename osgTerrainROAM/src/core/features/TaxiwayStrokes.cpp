// SPDX-License-Identifier: Apache-2.0
#include "TaxiwayStrokes.h"

#include <algorithm>
#include <cmath>

#include "HoldingPlaces.h"

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

class TaxiwayPainter
{
public:
    std::vector<Stroke> strokes;

    void middleLine(const std::vector<glm::dvec2>& path)
    {
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            if (path[i] != path[i + 1]) yellow(path[i], path[i + 1], kLineM);
    }

    void holdingPosition(const HoldingPosition& position)
    {
        const glm::dvec2 &place = position.place, &away = position.away;
        constexpr double kWideM = 0.3, kDashM = 0.9;
        const glm::dvec2 across(away.y, -away.x);
        const double halfM = 0.5 * position.taxiwayM;
        for (const double aheadM : {3.0 * kWideM, kWideM})
            yellow(place + aheadM * away - halfM * across, place + aheadM * away + halfM * across, kWideM);
        for (const double aheadM : {-kWideM, -3.0 * kWideM})
            for (double side = -halfM; side + kDashM <= halfM + 1e-9; side += 2.0 * kDashM)
                yellow(place + aheadM * away + side * across,
                       place + aheadM * away + (side + kDashM) * across, kWideM);
    }

private:
    void yellow(const glm::dvec2& a, const glm::dvec2& b, double widthM)
    {
        strokes.push_back({a, b, 0.5 * widthM, FeatureCells::yellow});
    }
};

} // namespace

std::vector<Stroke> taxiwayStrokes(const std::vector<glm::dvec2>& path, double widthM,
                                   std::span<const RunwayFrame> runways)
{
    if (path.size() < 2) return {};
    TaxiwayPainter painter;
    painter.middleLine(withRoundBends(path, widthM));
    for (const HoldingPosition& position : holdingPositionsAlong(path, widthM, runways))
        painter.holdingPosition(position);
    return std::move(painter.strokes);
}

} // namespace osgTerrainROAM::core
