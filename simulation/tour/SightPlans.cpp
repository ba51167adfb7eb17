// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/SightPlans.h"

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

constexpr int kLegs = 30, kStepsOfLeg = 8;
constexpr double kKeptBorderShare = 0.03; ///< of the shorter side, kept from the extent's edge
constexpr double kFirstS = 10.0, kLaterShare = 0.4;
constexpr double kEnoughS = 5.0; ///< seen so long, a sight has given two thirds of what it can
constexpr double kSharpDeg = 8.0, kWidestDeg = 32.0;
constexpr double kSpread = 0.5;                        ///< of the logarithm of good distances
constexpr double kLargestLegTurnDeg = 40.0;            ///< of flights of some minutes
constexpr double kReliefShare = 0.35, kEdgeCost = 0.3; ///< of a flight that has it always ahead
constexpr double kTurnCost = 0.2,
                 kRollCost = 0.05; ///< of a flight always in the steepest turn; of a roll to it
constexpr std::array<double, 3> kReliefReaches{10.0, 20.0, 35.0}; ///< medium heights
constexpr std::size_t kStarts = 16, kWaysOfStart = 24;
constexpr int kBearings = 24;
constexpr std::array<double, 5> kTurns{0.0, 0.4, -0.4, 0.8, -0.8}; ///< shares of the largest rate
constexpr double kLargestChange = 0.45;                            ///< of such a share within a leg

/// A look at the country from a place above the ground.
struct Glance
{
    glm::dvec2 place{0.0};
    double headingRad = 0.0;
    double heightM = 0.0; ///< above the ground
};

/// How well a look shows a sight: 1 where it is ahead, at the distance at which all of it is in the picture.
double shownIn(const Glance& look, const Sight& sight)
{
    const glm::dvec2 to = sight.place - look.place;
    const double awayM = glm::length(to);
    if (awayM < 2.0 * look.heightM) return 0.0; // below the picture
    const double ahead = (to.x * std::cos(look.headingRad) + to.y * std::sin(look.headingRad)) / awayM;
    const double asideDeg = foundation::degreesOf(std::acos(std::clamp(ahead, -1.0, 1.0)));
    if (asideDeg >= kWidestDeg) return 0.0;
    const double fit = std::log(awayM / (1.2 * sight.radiusM + 3.0 * look.heightM)) / kSpread;
    const double side = std::clamp((kWidestDeg - asideDeg) / (kWidestDeg - kSharpDeg), 0.0, 1.0);
    return side * std::exp(-0.5 * fit * fit);
}

/// What a flight has shown until a time.
class Shown
{
public:
    Shown(const TourTerrain& terrain, double durationS)
        : _terrain(&terrain), _durationS(durationS), _seenS(terrain.sights.size(), 0.0)
    {
    }

    /// `counts(sight)`: the share of it that nothing hides.
    template<class Counts>
    void add(const Glance& look, double atS, double lastsS, const Counts& counts)
    {
        const double worthS = lastsS * std::min(1.0, 20.0 / _durationS) * (atS < kFirstS ? 1.0 : kLaterShare);
        for (std::size_t i = 0; i < _seenS.size(); ++i)
            if (const double shown = shownIn(look, _terrain->sights[i]); shown > 0.01)
                _seenS[i] += worthS * shown * counts(_terrain->sights[i]);
    }

    double worth() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < _seenS.size(); ++i)
            if (_seenS[i] > 0.0) sum += worthOf(i);
        return sum;
    }

    glm::dvec2 best() const
    {
        std::size_t most = 0;
        for (std::size_t i = 1; i < _seenS.size(); ++i)
            if (worthOf(i) > worthOf(most)) most = i;
        return _terrain->sights[most].place;
    }

private:
    double worthOf(std::size_t i) const
    {
        return _terrain->sights[i].weight * (1.0 - std::exp(-_seenS[i] / kEnoughS));
    }

    const TourTerrain* _terrain;
    double _durationS;
    std::vector<double> _seenS; ///< by sight
};

/// A way as far as it is flown.
struct Way
{
    std::vector<glm::dvec2> places;
    std::vector<double> headingsRad;
    double turn = 0.0; ///< at its end, share of the largest rate
    Shown shown;
    double around = 0.0;               ///< of relief ahead, less edges, voids and turns
    double ground = 0.0, filled = 0.0; ///< looks at ground, and at such that was not measured

    double score() const { return shown.worth() + around; }
};

/// Flies ways over a terrain.
class Explorer
{
public:
    Explorer(const TourTerrain& terrain, const ReliefMap& map, const TourScale& scale, double durationS)
        : _terrain(terrain),
          _map(map),
          _scale(scale),
          _durationS(durationS),
          _legS(durationS / kLegs),
          _rate(std::min(scale.turnRateRadPerS, foundation::radiansOf(kLargestLegTurnDeg) / _legS)),
          _borderM(kKeptBorderShare * std::min(terrain.widthM(), terrain.depthM()))
    {
    }

    /// The ways that face a sight at their beginning, the best first.
    std::vector<Way> beginnings(const Sight& sight) const
    {
        std::vector<Way> ways;
        const double goodM = 1.2 * sight.radiusM + 3.0 * _scale.mediumM;
        for (int k = 0; k < kBearings; ++k)
            for (const double farther : {1.0, 1.6})
                for (const double asideDeg : {0.0, 14.0, -14.0})
                {
                    const double bearing = 2.0 * std::numbers::pi * k / kBearings;
                    const glm::dvec2 from =
                        sight.place - farther * goodM * glm::dvec2(std::cos(bearing), std::sin(bearing));
                    if (!isInside(from)) continue;
                    Way way{{from}, {bearing + foundation::radiansOf(asideDeg)}, 0.0, {_terrain, _durationS}};
                    look(way, 0.0);
                    ways.push_back(std::move(way));
                }
        return ways;
    }

    /// The way flown one leg on, its turn going over to another; nothing: it leaves the terrain.
    std::optional<Way> onward(const Way& from, double turn, int leg) const
    {
        Way way = from;
        for (int step = 0; step < kStepsOfLeg; ++step)
        {
            const double share = (step + 0.5) / kStepsOfLeg, stepS = _legS / kStepsOfLeg;
            const double rate = _rate * (from.turn + share * (turn - from.turn));
            const double middle = way.headingsRad.back() + 0.5 * stepS * rate;
            const glm::dvec2 place =
                way.places.back() + _scale.speedMps * stepS * glm::dvec2(std::cos(middle), std::sin(middle));
            if (!isInside(place)) return std::nullopt;
            way.places.push_back(place);
            way.headingsRad.push_back(way.headingsRad.back() + stepS * rate);
        }
        way.around -= kTurnCost / kLegs * turn * turn + kRollCost * std::fabs(turn - from.turn);
        way.turn = turn;
        look(way, (leg + 1) * _legS);
        return way;
    }

private:
    bool isInside(const glm::dvec2& place) const
    {
        return place.x > _terrain.westM + _borderM && place.x < _terrain.eastM - _borderM &&
               place.y > _terrain.southM + _borderM && place.y < _terrain.northM - _borderM;
    }

    void look(Way& way, double atS) const
    {
        const double heading = way.headingsRad.back();
        way.shown.add({way.places.back(), heading, _scale.mediumM}, atS, _legS,
                      [](const Sight&) { return 1.0; });
        for (const double reach : kReliefReaches)
        {
            const glm::dvec2 seen =
                way.places.back() + reach * _scale.mediumM * glm::dvec2(std::cos(heading), std::sin(heading));
            const double share = 1.0 / (kReliefReaches.size() * (kLegs + 1));
            const bool isGround = _map.contains(seen.x, seen.y);
            const double filled = isGround ? 1.0 - _map.measuredAt(seen.x, seen.y) : 1.0;
            way.around += share * (kReliefShare * _map.interestAt(seen.x, seen.y) - kEdgeCost * filled);
            way.ground += isGround ? 1.0 : 0.0;
            way.filled += isGround ? filled : 0.0;
        }
    }

    const TourTerrain& _terrain;
    const ReliefMap& _map;
    const TourScale& _scale;
    double _durationS, _legS, _rate, _borderM;
};

void keepBest(std::vector<Way>& ways)
{
    std::stable_sort(ways.begin(), ways.end(),
                     [](const Way& a, const Way& b) { return a.score() > b.score(); });
    if (ways.size() > kWaysOfStart) ways.erase(ways.begin() + kWaysOfStart, ways.end());
}

/// The share of a sight that no ground hides: of its middle, and of its near edge.
double openShare(const glm::dvec3& eye, const Sight& sight, const TourTerrain& terrain)
{
    constexpr int kRays = 10;
    const glm::dvec2 from(eye), to = sight.place - from;
    const double awayM = glm::length(to);
    double open = 0.0;
    for (const double beforeM : {0.0, std::min(0.7 * sight.radiusM, 0.5 * awayM)})
    {
        const glm::dvec2 aim = from + to * (1.0 - beforeM / awayM);
        const double aimM = terrain.heightM(aim.x, aim.y) + 8.0;
        bool isHidden = false;
        for (int i = 1; i < kRays && !isHidden; ++i)
        {
            const double share = static_cast<double>(i) / kRays;
            const glm::dvec2 at = glm::mix(from, aim, share);
            isHidden = terrain.heightM(at.x, at.y) > glm::mix(eye.z, aimM, share);
        }
        open += isHidden ? 0.0 : 0.5;
    }
    return open;
}

} // namespace

std::vector<FlightPlan> sightPlans(const TourTerrain& terrain, const ReliefMap& map, const TourScale& scale,
                                   double durationS)
{
    std::vector<Sight> first = terrain.sights;
    std::stable_sort(first.begin(), first.end(),
                     [](const Sight& a, const Sight& b) { return a.weight > b.weight; });
    first.resize(std::min(first.size(), kStarts));
    const Explorer explorer(terrain, map, scale, durationS);
    std::vector<FlightPlan> plans;
    for (const Sight& sight : first)
    {
        std::vector<Way> ways = explorer.beginnings(sight);
        keepBest(ways);
        for (int leg = 0; leg < kLegs; ++leg)
        {
            std::vector<Way> longer;
            for (const Way& way : ways)
                for (const double turn : kTurns)
                    if (std::fabs(turn - way.turn) <= kLargestChange)
                        if (auto next = explorer.onward(way, turn, leg)) longer.push_back(std::move(*next));
            keepBest(longer);
            ways = std::move(longer);
        }
        if (ways.empty()) continue;
        const Way& best = ways.front();
        FlightPlan plan;
        plan.places = best.places;
        plan.headingsRad = best.headingsRad;
        plan.highlight = best.shown.best();
        plan.score = best.score();
        plan.filledShare = best.ground > 0.0 ? best.filled / best.ground : 0.0;
        plans.push_back(std::move(plan));
    }
    return plans;
}

double shownSights(const FlightPlan& plan, const HeightProfile& profile, const TourTerrain& terrain,
                   const TourScale& scale, double durationS)
{
    Shown shown(terrain, durationS);
    for (int leg = 0; leg <= kLegs; ++leg)
    {
        const auto i = static_cast<std::size_t>(leg) * (plan.places.size() - 1) / kLegs;
        const glm::dvec3 eye(plan.places[i], profile.heightM[i]);
        const double aboveM = std::max(scale.clearanceM, eye.z - terrain.heightM(eye.x, eye.y));
        shown.add({plan.places[i], plan.headingsRad[i], aboveM}, durationS * leg / kLegs, durationS / kLegs,
                  [&](const Sight& sight) { return openShare(eye, sight, terrain); });
    }
    return shown.worth();
}

} // namespace simulation
