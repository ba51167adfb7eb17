// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/FlightPlan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <foundation/Angle.h>

namespace simulation
{
namespace
{

constexpr int kSteps = 240; ///< samples of a plan
constexpr int kLooks = 24;  ///< places along it from which it is rated
constexpr int kHeadings = 24;
constexpr std::size_t kHighlights = 8;
constexpr double kBorderShare = 0.03; ///< of the shorter side, kept from the extent's edge
constexpr double kOutsidePenalty = 0.9;
constexpr double kFilledPenalty = 0.9; ///< of ground that was not measured
constexpr double kLandmarkBonus = 1.5; ///< for a highlight of prominence 1
constexpr double kOverrunScore = -1e6; ///< of a plan that leaves the extent, less the metres it does
constexpr std::array<double, 4> kAheads = {0.3, 0.7, 1.2,
                                           2.0}; ///< of the length, from a plan's end to its highlight
constexpr std::array<double, 5> kFanDeg = {-22.0, -11.0, 0.0, 11.0, 22.0};

/// How far a look reaches, in medium heights, and what it counts.
struct Look
{
    double reach;
    double weight;
};
constexpr std::array<Look, 5> kReaches = {{{2.0, 0.6}, {4.0, 1.0}, {8.0, 1.0}, {14.0, 0.8}, {22.0, 0.5}}};

/// Turn rate along the way, as a share of the largest: sin(periods·π·x)·amplitude.
struct Bend
{
    double periods;
    double amplitude;
};
constexpr std::array<Bend, 5> kBends = {{{2.0, 1.0}, {2.0, -1.0}, {1.0, 0.8}, {1.0, -0.8}, {2.0, 0.5}}};

struct Highlight
{
    glm::dvec2 place;
    double prominence;
};

std::vector<Highlight> highlights(const ReliefMap& map)
{
    struct Cell
    {
        double interest;
        int column;
        int row;
    };
    std::vector<Cell> cells;
    for (int row = 0; row < map.rows(); ++row)
        for (int column = 0; column < map.columns(); ++column)
            cells.push_back({map.interest(column, row), column, row});
    std::stable_sort(cells.begin(), cells.end(),
                     [](const Cell& a, const Cell& b) { return a.interest > b.interest; });
    const int apart = std::max(2, std::max(map.columns(), map.rows()) / 12);
    std::vector<Cell> chosen;
    for (const Cell& cell : cells)
    {
        const bool isNear = std::any_of(chosen.begin(), chosen.end(),
                                        [&](const Cell& other) {
                                            return std::max(std::abs(other.column - cell.column),
                                                            std::abs(other.row - cell.row)) < apart;
                                        });
        if (!isNear) chosen.push_back(cell);
        if (chosen.size() == kHighlights) break;
    }
    std::vector<Highlight> places;
    for (const Cell& cell : chosen)
        places.push_back({map.centre(cell.column, cell.row), map.prominence(cell.column, cell.row)});
    return places;
}

/// A plan from the origin, heading east at first.
FlightPlan bentPlan(const Bend& bend, const TourScale& scale)
{
    FlightPlan plan;
    const double step = scale.lengthM / kSteps;
    glm::dvec2 place(0.0);
    double heading = 0.0;
    for (int i = 0; i <= kSteps; ++i)
    {
        plan.places.push_back(place);
        plan.headingsRad.push_back(heading);
        const double middle = (i + 0.5) / kSteps;
        const double curvature = scale.turnRateRadPerS / scale.speedMps * bend.amplitude *
                                 std::sin(bend.periods * std::numbers::pi * middle);
        place += step * glm::dvec2(std::cos(heading + 0.5 * step * curvature),
                                   std::sin(heading + 0.5 * step * curvature));
        heading += step * curvature;
    }
    return plan;
}

/// The plan turned and moved so that it ends `ahead` before the highlight and faces it.
FlightPlan endingAt(const FlightPlan& plan, const glm::dvec2& highlight, double headingRad, double ahead)
{
    FlightPlan placed = plan;
    const double turn = headingRad - plan.headingsRad.back();
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    const glm::dvec2 end = highlight - ahead * glm::dvec2(std::cos(headingRad), std::sin(headingRad));
    for (std::size_t i = 0; i < placed.places.size(); ++i)
    {
        const glm::dvec2 from = plan.places[i] - plan.places.back();
        placed.places[i] = end + glm::dvec2(c * from.x - s * from.y, s * from.x + c * from.y);
        placed.headingsRad[i] += turn;
    }
    placed.highlight = highlight;
    return placed;
}

/// Returns the rating, and sets the share of ground ahead that was not measured.
double rating(FlightPlan& plan, const ReliefMap& map, const TourScale& scale)
{
    double sum = 0.0, seenGround = 0.0, seenFilled = 0.0;
    for (int look = 0; look < kLooks; ++look)
    {
        const std::size_t i = static_cast<std::size_t>(look * kSteps / (kLooks - 1));
        for (const double fanDeg : kFanDeg)
            for (const auto& [reach, weight] : kReaches)
            {
                const double direction = plan.headingsRad[i] + foundation::radiansOf(fanDeg);
                const glm::dvec2 seen =
                    plan.places[i] +
                    reach * scale.mediumM * glm::dvec2(std::cos(direction), std::sin(direction));
                if (!map.contains(seen.x, seen.y))
                {
                    sum -= weight * kOutsidePenalty;
                    continue;
                }
                const double filled = 1.0 - map.measuredAt(seen.x, seen.y);
                sum += weight * (map.interestAt(seen.x, seen.y) - kFilledPenalty * filled);
                seenGround += weight;
                seenFilled += weight * filled;
            }
    }
    plan.filledShare = seenGround > 0.0 ? seenFilled / seenGround : 0.0;
    return sum / (kLooks * kFanDeg.size());
}

double overrunM(const FlightPlan& plan, const TourTerrain& terrain)
{
    const double border = kBorderShare * std::min(terrain.widthM(), terrain.depthM());
    double worst = 0.0;
    for (const glm::dvec2& place : plan.places)
        worst = std::max({worst, terrain.westM + border - place.x, place.x - terrain.eastM + border,
                          terrain.southM + border - place.y, place.y - terrain.northM + border});
    return worst;
}

} // namespace

std::vector<FlightPlan> flightPlans(const TourTerrain& terrain, const ReliefMap& map, const TourScale& scale)
{
    std::vector<FlightPlan> shapes;
    for (const Bend& bend : kBends)
        shapes.push_back(bentPlan(bend, scale));
    std::vector<FlightPlan> inside;
    std::vector<FlightPlan> outside;
    for (const auto& [place, prominence] : highlights(map))
        for (const double ahead : kAheads)
        {
            std::optional<FlightPlan> best;
            for (const FlightPlan& shape : shapes)
                for (int k = 0; k < kHeadings; ++k)
                {
                    FlightPlan plan =
                        endingAt(shape, place, 2.0 * std::numbers::pi * k / kHeadings, ahead * scale.lengthM);
                    const double overrun = overrunM(plan, terrain);
                    const double rated = rating(plan, map, scale) + kLandmarkBonus * prominence;
                    plan.score = overrun > 0.0 ? kOverrunScore - overrun : rated;
                    if (!best || plan.score > best->score) best = std::move(plan);
                }
            (best->score > 0.5 * kOverrunScore ? inside : outside).push_back(std::move(*best));
        }
    return inside.empty() ? outside : inside;
}

} // namespace simulation
