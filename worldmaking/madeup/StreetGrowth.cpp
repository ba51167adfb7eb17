// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/StreetGrowth.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "worldmaking/madeup/SmoothPath.h"
#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

using scenery::models::Dice;

constexpr double kStreetStepM = 10.0, kBesideM = 42.0; ///< between streets that do not meet
constexpr double kKnotM = 38.0;                        ///< between crossings
constexpr double kStreetReachM = 75.0;                 ///< a street is lengthened so far to end on another
constexpr double kLeastStreetM = 55.0, kLeastSine = 0.75;

/// A street that may be built.
struct Proposal
{
    glm::dvec2 from, direction;
    double lengthM;
    int generation;
    std::size_t parent;
};

class Grower
{
public:
    Grower(const Settlement& settlement, int number, const StreetRules& rules, WayWeb& web)
        : _settlement(settlement),
          _number(number),
          _rules(rules),
          _web(web),
          _dice(seedFor(rules.seed, 21, static_cast<std::uint64_t>(number)))
    {
    }

    void grow()
    {
        const std::size_t roads = _web.ways().size();
        for (std::size_t way = 0; way < roads; ++way)
            propose(way, _web.ways()[way].points, 0);
        while (!_proposals.empty())
        {
            const Proposal proposal = _proposals.front();
            _proposals.pop_front();
            tryOne(proposal);
        }
    }

private:
    int lastGeneration() const
    {
        return _settlement.kind == SettlementKind::town
                   ? 3
                   : (_settlement.kind == SettlementKind::village ? 1 : 0);
    }

    void propose(std::size_t way, const std::vector<glm::dvec2>& line, int generation)
    {
        if (generation > lastGeneration()) return;
        const auto points = evenPoints(line, kStreetStepM);
        const bool isTown = _settlement.kind == SettlementKind::town;
        double next = generation == 0 ? 0.0 : 60.0;
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
        {
            next -= kStreetStepM;
            if (next > 0.0 || glm::distance(points[i], _settlement.middle) > _settlement.radiusM()) continue;
            next = _dice.between(65.0, isTown ? 95.0 : 130.0);
            const glm::dvec2 along = glm::normalize(points[i + 1] - points[i - 1]), across(-along.y, along.x);
            for (const double side : {1.0, -1.0})
            {
                const double most = isTown ? 260.0 : 170.0;
                if (_dice.chance(isTown ? 0.92 : 0.7))
                    _proposals.push_back(
                        {points[i], side * across, _dice.between(0.5 * most, most), generation, way});
            }
        }
    }

    bool isInside(const glm::dvec2& place) const
    {
        return glm::distance(place, _settlement.middle) < 1.12 * _settlement.radiusM() &&
               _rules.ground.isLand(place) && _rules.isFree(place);
    }

    bool isGentle(const glm::dvec2& a, const glm::dvec2& b) const
    {
        const auto from = _rules.ground.heightM(a), to = _rules.ground.heightM(b);
        return from && to && std::abs(*to - *from) <= kSteepestStreet * glm::distance(a, b);
    }

    bool isByKnot(const glm::dvec2& place) const
    {
        return std::any_of(_knots.begin(), _knots.end(),
                           [&](const glm::dvec2& knot) { return glm::distance(knot, place) < kKnotM; }) ||
               isByEnd(place);
    }

    bool isByEnd(const glm::dvec2& place) const
    {
        return std::any_of(_web.ways().begin(), _web.ways().end(),
                           [&](const MadeWay& way)
                           {
                               return glm::distance(way.points.front(), place) < kKnotM ||
                                      glm::distance(way.points.back(), place) < kKnotM;
                           });
    }

    /// Whether a street to `to` would come too near to another than its parent; beside the parent it grows
    /// away.
    bool isCrowded(const glm::dvec2& place, const Proposal& proposal, double alongM) const
    {
        const auto other =
            _web.nearest(place, kBesideM, alongM < 1.5 * kBesideM ? proposal.parent : WayWeb::kNone);
        return other.has_value();
    }

    /// The street ahead, where this one can end on it.
    std::optional<glm::dvec2> endAhead(const glm::dvec2& place, const glm::dvec2& direction) const
    {
        const auto other = _web.nearest(place + 0.5 * kStreetReachM * direction, kStreetReachM);
        if (!other) return std::nullopt;
        const MapBox reach = boxOf({place, place + kStreetReachM * direction});
        const MapBox ahead{reach.low - 1.0, reach.high + 1.0}; // wider than rounding
        std::optional<glm::dvec2> best;
        double least = kStreetReachM;
        for (const MadeWay& way : _web.ways())
            for (std::size_t i = 0; i + 1 < way.points.size(); ++i)
            {
                const glm::dvec2 &a = way.points[i], &b = way.points[i + 1];
                if (!ahead.meets({glm::min(a, b), glm::max(a, b)})) continue;
                const auto hit = crossingOf(place, place + kStreetReachM * direction, a, b);
                if (!hit || glm::distance(*hit, place) >= least) continue;
                const glm::dvec2 along = glm::normalize(b - a);
                if (std::abs(direction.x * along.y - direction.y * along.x) < kLeastSine) continue;
                least = glm::distance(*hit, place);
                best = hit;
            }
        return best;
    }

    void tryOne(const Proposal& proposal)
    {
        if (isByKnot(proposal.from)) return;
        std::vector<glm::dvec2> line{proposal.from};
        glm::dvec2 direction = proposal.direction;
        const double turn = _dice.between(-0.0012, 0.0012) * kStreetStepM;
        std::optional<glm::dvec2> end;
        for (double at = kStreetStepM; at <= proposal.lengthM && !end; at += kStreetStepM)
        {
            direction = glm::normalize(direction + turn * glm::dvec2(-direction.y, direction.x));
            const glm::dvec2 place = line.back() + kStreetStepM * direction;
            if (!isInside(place) || !isGentle(line.back(), place)) break;
            if (isCrowded(place, proposal, at))
            {
                end = endAhead(line.back(), direction);
                break;
            }
            line.push_back(place);
        }
        if (!end && line.size() > 4) end = endAhead(line.back(), direction);
        if (end && (isByKnot(*end) || !isGentle(line.back(), *end) || !isInside(*end) ||
                    glm::distance(*end, proposal.from) < kLeastStreetM))
            end.reset();
        if (end)
            line.push_back(*end);
        else if (isCrowded(line.back(), proposal, 1e9) ||
                 kStreetStepM * static_cast<double>(line.size() - 1) < kLeastStreetM)
            return;
        build(proposal, line, end);
    }

    void build(const Proposal& proposal, const std::vector<glm::dvec2>& line,
               const std::optional<glm::dvec2>& end)
    {
        _web.insert(proposal.parent, proposal.from);
        _knots.push_back(proposal.from);
        if (end) _knots.push_back(*end);
        const std::string_view kind = proposal.generation < 2 ? "residential" : "living_street";
        const std::size_t way = _web.add({kind, evenPoints(line, 20.0), _number});
        propose(way, line, proposal.generation + 1);
    }

    const Settlement& _settlement;
    int _number;
    const StreetRules& _rules;
    WayWeb& _web;
    Dice _dice;
    std::deque<Proposal> _proposals;
    std::vector<glm::dvec2> _knots;
};

} // namespace

void growStreets(const Settlement& settlement, int number, const StreetRules& rules, WayWeb& web)
{
    Grower(settlement, number, rules, web).grow();
}

} // namespace worldmaking
