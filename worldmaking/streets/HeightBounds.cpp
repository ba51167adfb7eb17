// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/HeightBounds.h"

#include <algorithm>
#include <cmath>

#include "worldmaking/streets/Overpass.h"

namespace worldmaking
{

namespace
{

constexpr double kRampShare = 0.9; ///< of a grade, that bounds near crossings count on

/// By how much each node of a row can leave the height that its crossings hold: infinite where none does.
class RowReach
{
public:
    explicit RowReach(const HeightNodes& nodes, std::size_t row) : _row(nodes.rows[row])
    {
        const std::size_t count = _row.points.size();
        _fromStartM.assign(count, 0.0);
        for (std::size_t k = 2; k < count; ++k) // the first two lie in the plane of the crossing
            _fromStartM[k] = _fromStartM[k - 1] + stepAt(k - 1, k);
        _fromEndM.assign(count, 0.0);
        for (std::size_t k = count - 2; k-- > 0;)
            _fromEndM[k] = _fromEndM[k + 1] + stepAt(k, k + 1);
    }

    double fromStartM(std::size_t k) const { return _fromStartM[k]; }
    double fromEndM(std::size_t k) const { return _fromEndM[k]; }

private:
    double stepAt(std::size_t a, std::size_t b) const
    {
        return kRampShare * _row.stepM * std::min(_row.steepest[a], _row.steepest[b]);
    }

    const HeightRow& _row;
    std::vector<double> _fromStartM, _fromEndM;
};

/// Collects bounds.
class BoundMaker
{
public:
    BoundMaker(const HeightNodes& nodes, const std::vector<double>& wishesM)
        : _nodes(nodes), _wishesM(wishesM)
    {
        std::vector<char> hasStart(nodes.rows.size(), 0), hasEnd = hasStart;
        for (const CrossingArea& area : nodes.areas)
        {
            const auto isTube = [&](const StreetArm& arm)
            { return nodes.rows[arm.chain].isTunnel[nodes.mouth(arm)] != 0; };
            const auto tubes = std::count_if(area.arms.begin(), area.arms.end(), isTube);
            for (const StreetArm& arm : area.arms)
                if (tubes < 2 || !isTube(arm)) // tunnels that part at their portal take it below
                    (arm.isEnd ? hasEnd : hasStart)[arm.chain] = 1;
        }
        _hasStart = std::move(hasStart), _hasEnd = std::move(hasEnd);
    }

    void addMost(std::size_t row, std::size_t k, double mostM)
    {
        const RowReach reach(_nodes, row);
        const HeightRow& its = _nodes.rows[row];
        if (_hasStart[row]) mostM = std::max(mostM, _wishesM[its.first] - reach.fromStartM(k));
        if (_hasEnd[row]) mostM = std::max(mostM, _wishesM[its.first + its.last()] - reach.fromEndM(k));
        scenery::HeightBound bound{its.first + k};
        bound.mostM = mostM;
        bounds.push_back(bound);
    }

    void addLeast(std::size_t row, std::size_t k, double leastM)
    {
        const RowReach reach(_nodes, row);
        const HeightRow& its = _nodes.rows[row];
        if (_hasStart[row]) leastM = std::min(leastM, _wishesM[its.first] + reach.fromStartM(k));
        if (_hasEnd[row]) leastM = std::min(leastM, _wishesM[its.first + its.last()] + reach.fromEndM(k));
        scenery::HeightBound bound{its.first + k};
        bound.leastM = leastM;
        bounds.push_back(bound);
    }

    std::vector<scenery::HeightBound> bounds;

private:
    const HeightNodes& _nodes;
    const std::vector<double>& _wishesM;
    std::vector<char> _hasStart, _hasEnd;
};

} // namespace

std::vector<DugTunnel> dugTunnels(const HeightNodes& nodes, const std::vector<double>& wishesM,
                                  const foundation::HeightInPlan& ground)
{
    std::vector<DugTunnel> dug;
    for (std::size_t r = 0; r < nodes.rows.size(); ++r)
    {
        const HeightRow& row = nodes.rows[r];
        const auto isCovered = [&](std::size_t k)
        {
            const auto groundM = ground(row.points[k].position);
            return !groundM || *groundM - wishesM[row.first + k] >= kTunnelRoofM;
        };
        for (std::size_t first = 0; first <= row.last(); ++first)
        {
            if (row.isTunnel[first] == 0) continue;
            std::size_t last = first;
            while (last < row.last() && row.isTunnel[last + 1] != 0)
                ++last;
            std::size_t firstCovered = first, lastCovered = last;
            while (firstCovered <= last && !isCovered(firstCovered))
                ++firstCovered;
            while (lastCovered > firstCovered && !isCovered(lastCovered))
                --lastCovered;
            // Without a hill all of it, and a step beyond, which rounding takes; else what the hill leaves
            // bare in the middle.
            if (firstCovered > last)
                dug.push_back({r, first > 0 ? first - 1 : 0, std::min(last + 1, row.last())});
            else
                for (std::size_t k = firstCovered; k <= lastCovered; ++k)
                    if (!isCovered(k)) dug.push_back({r, k, k});
            first = last;
        }
    }
    return dug;
}

std::vector<scenery::HeightBound> heightBoundsOf(const HeightNodes& nodes, const std::vector<ChainCut>& cuts,
                                                 std::span<const DugTunnel> tunnels,
                                                 const Crossings& crossings,
                                                 const std::vector<double>& wishesM,
                                                 const foundation::HeightInPlan& ground)
{
    BoundMaker maker(nodes, wishesM);
    for (const DugTunnel& tunnel : tunnels)
        for (std::size_t k = tunnel.first; k <= tunnel.last; ++k)
            if (const auto groundM = ground(nodes.rows[tunnel.row].points[k].position))
                maker.addMost(tunnel.row, k, *groundM - kTunnelRoofM);
    for (const CrossedPlace& place : crossings.crossed)
    {
        const auto groundM = ground(place.place);
        if (!groundM) continue;
        const HeightRow& row = nodes.rows[place.chain];
        const double alongM = place.alongM - cuts[place.chain].startM;
        const std::size_t first = row.around(alongM - place.halfM)[0],
                          last = row.around(alongM + place.halfM)[1];
        for (std::size_t k = first; k <= last; ++k)
            place.isStreetAbove ? maker.addLeast(place.chain, k, *groundM + place.apartM)
                                : maker.addMost(place.chain, k, *groundM - place.apartM);
    }
    const auto addApart = [&](const Overpass& pass)
    {
        if (pass.isUpperLifted == pass.isLowerSunk) return;
        const HeightRow &upper = nodes.rows[pass.upper], &lower = nodes.rows[pass.lower];
        const auto above = upper.around(pass.upperM - cuts[pass.upper].startM),
                   below = lower.around(pass.lowerM - cuts[pass.lower].startM);
        for (const std::size_t a : above)
            for (const std::size_t b : below)
                pass.isUpperLifted ? maker.addLeast(pass.upper, a, wishesM[lower.first + b] + pass.riseM)
                                   : maker.addMost(pass.lower, b, wishesM[upper.first + a] - pass.riseM);
    };
    for (const auto* passes : {&crossings.overpasses, &crossings.footLevels})
        for (const Overpass& pass : *passes)
            addApart(pass);
    return std::move(maker.bounds);
}

} // namespace worldmaking
