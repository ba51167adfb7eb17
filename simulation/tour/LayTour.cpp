// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/LayTour.h"

#include <algorithm>
#include <cmath>

#include "simulation/tour/FlightPlan.h"
#include "simulation/tour/HeightProfile.h"
#include "simulation/tour/SightPlans.h"
#include "simulation/tour/TourScenario.h"

namespace simulation
{
namespace
{

constexpr double kExcessWeight = 1.0; ///< what a medium height too high costs, in units of a plan's rating
constexpr double kFlightVertexEveryS = 0.5;
constexpr double kCheckEveryS = 1.0 / 48.0;

/// An airborne eye that looks where it flies sees sky when it climbs: like a helicopter, this one carries its
/// nose below its path, and follows the path's slope by half.
constexpr double kNoseDownRad = 0.09;
constexpr double kPitchShare = 0.5;

struct Choice
{
    FlightPlan plan;
    HeightProfile profile;
};

Choice bestChoice(const TourTerrain& terrain, const ReliefMap& map, const TourScale& scale, double durationS)
{
    Choice best;
    double bestScore = -1e300;
    std::vector<FlightPlan> plans;
    if (!terrain.sights.empty()) plans = sightPlans(terrain, map, scale, durationS);
    const bool isPastSights = !plans.empty();
    if (!isPastSights) plans = flightPlans(terrain, map, scale);
    for (const FlightPlan& plan : plans)
    {
        HeightProfile profile = heightProfile(plan, terrain, scale);
        const double shown =
            isPastSights ? shownSights(plan, profile, terrain, scale, durationS) : plan.score;
        const double score = shown - kExcessWeight * profile.excess;
        if (score <= bestScore) continue;
        bestScore = score;
        best = {plan, std::move(profile)};
    }
    return best;
}

std::vector<PathVertex> timedVertices(const Choice& choice, double durationS)
{
    const auto intervals =
        static_cast<std::size_t>(std::max(4.0, std::round(durationS / kFlightVertexEveryS)));
    const double last = static_cast<double>(choice.plan.places.size() - 1);
    std::vector<PathVertex> vertices;
    for (std::size_t k = 0; k <= intervals; ++k)
    {
        const double share = static_cast<double>(k) / static_cast<double>(intervals);
        const auto i = std::min(static_cast<std::size_t>(share * last), choice.plan.places.size() - 2);
        const double t = share * last - static_cast<double>(i);
        const glm::dvec2 place = glm::mix(choice.plan.places[i], choice.plan.places[i + 1], t);
        const double height = glm::mix(choice.profile.heightM[i], choice.profile.heightM[i + 1], t);
        const double slope =
            (choice.profile.heightM[i + 1] - choice.profile.heightM[i]) / choice.profile.stepM;
        Orientation orientation;
        orientation.pitchRad = kNoseDownRad - kPitchShare * std::atan(slope);
        vertices.push_back({share * durationS, glm::dvec3(place, height), orientation});
    }
    return vertices;
}

/// Smallest and largest height above ground on the curve that the player will fly.
std::pair<double, double> heightsAboveGround(const std::vector<PathVertex>& vertices,
                                             const TourTerrain& terrain)
{
    const PathCurve curve(vertices, FollowingMode::follow, std::nullopt);
    std::pair<double, double> range(1e300, -1e300);
    const auto checks = static_cast<int>(std::floor(curve.end() / kCheckEveryS));
    for (int i = 0; i <= checks; ++i)
    {
        const glm::dvec3 place = curve.at(i * kCheckEveryS).position;
        const double above = place.z - terrain.heightM(place.x, place.y);
        range = {std::min(range.first, above), std::max(range.second, above)};
    }
    return range;
}

ScenarioObject airborneOwnship()
{
    MiscObject aircraft;
    aircraft.name = "aircraft";
    aircraft.category = "none";
    aircraft.massKg = 1100.0;
    aircraft.box = {{0.0, 0.0, 0.0}, 8.0, 11.0, 2.7};
    aircraft.properties.values = {{"domain", "air"}};
    ScenarioObject ownship;
    ownship.name = "ownship";
    ownship.object = std::move(aircraft);
    return ownship;
}

} // namespace

foundation::Result<Tour> layTour(const TourTerrain& terrain, const TourOptions& options)
{
    if (!(options.durationS >= 4.0 && options.durationS <= 3600.0))
        return foundation::Error{"tour", "a duration of " + std::to_string(options.durationS) + " s",
                                 "choose 4 to 3600 seconds"};
    if (!(terrain.widthM() > 0.0 && terrain.depthM() > 0.0) ||
        !std::isfinite(terrain.widthM() + terrain.depthM()))
        return foundation::Error{"tour",
                                 "no ground between " + std::to_string(terrain.widthM()) +
                                     " m of width and " + std::to_string(terrain.depthM()) + " m of depth",
                                 "give a terrain of two samples or more in each direction"};
    const TourScale scale = TourScale::of(terrain, options.durationS);
    const ReliefMap map(terrain);
    const Choice choice = bestChoice(terrain, map, scale, options.durationS);
    if (!map.isFinite() || choice.plan.places.empty())
        return foundation::Error{"tour", "the terrain has heights that are not numbers", "fill its voids"};

    std::vector<PathVertex> vertices = timedVertices(choice, options.durationS);
    std::pair<double, double> heights = heightsAboveGround(vertices, terrain);
    const double missing = scale.clearanceM - heights.first;
    if (missing > 0.0)
    {
        for (PathVertex& vertex : vertices)
            vertex.position.z += missing;
        heights = heightsAboveGround(vertices, terrain);
    }
    Tour tour;
    tour.speedMps = scale.speedMps;
    tour.lowestM = heights.first;
    tour.highestM = heights.second;
    tour.filledShare = choice.plan.filledShare;
    tour.highlight = {choice.plan.highlight.x, choice.plan.highlight.y,
                      terrain.heightM(choice.plan.highlight.x, choice.plan.highlight.y)};
    tour.scenario = tourScenario(terrain, airborneOwnship(), vertices, "A flight over " + terrain.name());
    return tour;
}

} // namespace simulation
