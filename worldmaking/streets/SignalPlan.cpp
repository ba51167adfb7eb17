// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/SignalPlan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "worldmaking/streets/WaitTags.h"

namespace worldmaking
{

namespace
{

constexpr double kLightAheadM = 60.0, kLightNearerM = 30.0, kFootLightNearM = 25.0;
constexpr double kOneProgrammeM = 30.0; ///< between two crossings
constexpr double kOneLightM = 20.0;     ///< between lights in a street
constexpr double kNoCrossingM = std::numeric_limits<double>::infinity();

/// A node on a chain, between its ends. Direction: 1 along the chain.
struct WaitNode
{
    std::size_t chain = 0;
    double atM = 0.0;
    int direction = 0;
    WaitTags tags;
};

class SignalPlanner
{
public:
    SignalPlanner(const StreetMap& map, const StreetGraph& graph, const std::vector<CentreLine>& lines,
                  const std::vector<ChainCut>& cuts)
        : _map(map),
          _graph(graph),
          _lines(lines),
          _cuts(cuts),
          _isNodeLit(graph.crossings.size(), 0),
          _root(graph.crossings.size())
    {
        _plan.arms.resize(graph.chains.size());
        _plan.placeOf.assign(graph.crossings.size(), -1);
    }

    SignalPlan plan()
    {
        readNodes();
        for (const WaitNode& node : _nodes)
            if (node.tags.isLight) takeLight(node);
        lightByFootLights();
        joinPlaces();
        decidePlaces();
        for (const WaitNode& node : _nodes)
        {
            if (node.tags.isFootLight && !node.tags.isLight) takeFootLight(node);
            if (node.tags.isStop || node.tags.givesWay) takeSign(node);
        }
        for (std::size_t i = 0; i < _graph.crossings.size(); ++i)
            for (const StreetArm& arm : _graph.crossings[i].arms)
                armAt(arm.chain, arm.isEnd).place = _plan.placeOf[i];
        return std::move(_plan);
    }

private:
    double lengthM(std::size_t chain) const
    {
        return _lines[chain].lengthM() - _cuts[chain].startM - _cuts[chain].endM;
    }

    int crossingAt(std::size_t chain, bool isEnd) const
    {
        return isEnd ? _graph.chains[chain].endCrossing : _graph.chains[chain].startCrossing;
    }

    /// From a node to an end of its chain's road; far where no crossing is there.
    double toEndM(const WaitNode& node, bool isEnd) const
    {
        if (crossingAt(node.chain, isEnd) < 0) return kNoCrossingM;
        return isEnd ? lengthM(node.chain) - node.atM : node.atM;
    }

    ArmSignals& armAt(std::size_t chain, bool isEnd) { return _plan.arms[chain][isEnd ? 1 : 0]; }

    const StreetTraits& traitsAtEnd(const StreetArm& arm) const
    {
        const StreetChain& chain = _graph.chains[arm.chain];
        return _graph.traitsAt(chain, arm.isEnd ? chain.pieces.size() - 1 : 0);
    }

    bool leadsIn(const StreetArm& arm) const
    {
        const StreetTraits& traits = traitsAtEnd(arm);
        return (arm.isEnd ? traits.forwardLanes : traits.backwardLanes) > 0 || traits.isSingleTrack();
    }

    bool isLitCrossing(int crossing) const
    {
        return crossing >= 0 && _plan.placeOf[static_cast<std::size_t>(crossing)] >= 0;
    }

    void readNodes()
    {
        for (std::size_t i = 0; i < _graph.crossings.size(); ++i)
            for (const std::uint32_t point : _graph.crossings[i].points)
                if (const auto found = _map.nodeTags.find(point); found != _map.nodeTags.end())
                    if (waitTagsOf(found->second).isLight) _isNodeLit[i] = 1;
        for (std::size_t i = 0; i < _graph.chains.size(); ++i)
            for (std::size_t point = 1; point + 1 < _graph.chains[i].points.size(); ++point)
                readNode(i, point);
    }

    void readNode(std::size_t index, std::size_t point)
    {
        const StreetChain& chain = _graph.chains[index];
        const auto found = _map.nodeTags.find(chain.points[point]);
        if (found == _map.nodeTags.end()) return;
        WaitNode node{index, 0.0, 0, waitTagsOf(found->second)};
        if (node.tags.isEmpty()) return;
        node.atM = std::clamp(_lines[index].pointsM()[point] - _cuts[index].startM, 0.0, lengthM(index));
        const StreetChain::Piece& before = chain.pieces[point - 1];
        const bool isAlongWay = before.traits % 2 == 0; // of a way first as it runs, then reversed
        node.direction = isAlongWay ? node.tags.direction : -node.tags.direction;
        const StreetTraits& traits = _graph.traits[before.traits];
        if (!traits.isSingleTrack() && traits.backwardLanes == 0) node.direction = 1;
        if (!traits.isSingleTrack() && traits.forwardLanes == 0) node.direction = -1;
        _nodes.push_back(node);
    }

    /// For whom a light or a sign is: along the chain or against it; 0: no crossing is near.
    int directionOf(const WaitNode& node) const
    {
        if (node.direction != 0) return node.direction;
        const double endM = toEndM(node, true), startM = toEndM(node, false);
        return std::min(endM, startM) > kLightNearerM ? 0 : endM <= startM ? 1 : -1;
    }

    void takeLight(const WaitNode& node)
    {
        const int direction = directionOf(node);
        const double aheadM = direction == 0 ? kNoCrossingM : toEndM(node, direction > 0);
        if (aheadM > kLightAheadM)
        {
            const bool isBoth = node.direction == 0 || node.tags.isFootLight;
            addBetween(node.chain, node.atM, isBoth || direction > 0, isBoth || direction < 0,
                       node.tags.isFootLight);
            return;
        }
        ArmSignals& arm = armAt(node.chain, direction > 0);
        arm.isLit = true;
        if (!arm.lineM || *arm.lineM > aheadM) arm.lineM = aheadM;
        if (node.tags.isFootLight) arm.footM = aheadM;
    }

    void addBetween(std::size_t chain, double atM, bool isForward, bool isBackward, bool isFoot)
    {
        for (StreetLight& light : _plan.between)
            if (light.chain == chain && std::abs(light.atM - atM) < kOneLightM)
            {
                if (isFoot && !light.isFoot) light.atM = atM;
                light.isForward |= isForward || isFoot;
                light.isBackward |= isBackward || isFoot;
                light.isFoot |= isFoot;
                return;
            }
        _plan.between.push_back({chain, atM, isForward, isBackward, isFoot});
    }

    /// Crossings of which the map has the lights for people on foot alone.
    void lightByFootLights()
    {
        std::map<int, std::map<std::size_t, bool>> arms; // of crossings
        for (const WaitNode& node : _nodes)
            for (const bool isEnd : {false, true})
                if (node.tags.isFootLight && !node.tags.isLight && toEndM(node, isEnd) <= kFootLightNearM)
                    arms[crossingAt(node.chain, isEnd)][2 * node.chain + (isEnd ? 1 : 0)] = true;
        for (const auto& [crossing, lit] : arms)
        {
            const auto index = static_cast<std::size_t>(crossing);
            const std::size_t all = _graph.crossings[index].arms.size();
            if (all >= 3 && lit.size() >= 2 && 2 * lit.size() >= all) _isNodeLit[index] = 1;
        }
    }

    bool hasLight(int crossing)
    {
        const auto index = static_cast<std::size_t>(crossing);
        const auto& arms = _graph.crossings[index].arms;
        return _isNodeLit[index] != 0 ||
               std::any_of(arms.begin(), arms.end(),
                           [&](const StreetArm& arm) { return armAt(arm.chain, arm.isEnd).isLit; });
    }

    std::size_t rootOf(std::size_t crossing)
    {
        while (_root[crossing] != crossing)
            crossing = _root[crossing] = _root[_root[crossing]];
        return crossing;
    }

    bool isInner(std::size_t chain)
    {
        const int from = crossingAt(chain, false), to = crossingAt(chain, true);
        return from >= 0 && to >= 0 && from != to && lengthM(chain) <= kOneProgrammeM &&
               rootOf(static_cast<std::size_t>(from)) == rootOf(static_cast<std::size_t>(to));
    }

    void joinPlaces()
    {
        for (std::size_t i = 0; i < _root.size(); ++i)
            _root[i] = i;
        for (std::size_t i = 0; i < _graph.chains.size(); ++i)
        {
            const int from = crossingAt(i, false), to = crossingAt(i, true);
            if (from < 0 || to < 0 || from == to || lengthM(i) > kOneProgrammeM) continue;
            if (!hasLight(from) || !hasLight(to)) continue;
            const std::size_t a = rootOf(static_cast<std::size_t>(from)),
                              b = rootOf(static_cast<std::size_t>(to));
            _root[std::max(a, b)] = std::min(a, b);
        }
    }

    void decidePlaces()
    {
        std::map<std::size_t, std::vector<std::size_t>> places;
        for (std::size_t i = 0; i < _root.size(); ++i)
            places[rootOf(i)].push_back(i);
        for (const auto& [root, crossings] : places)
            decidePlace(crossings);
    }

    void decidePlace(const std::vector<std::size_t>& crossings)
    {
        bool isNodeLit = false;
        std::size_t lit = 0;
        std::vector<StreetArm> leading;
        for (const std::size_t crossing : crossings)
        {
            isNodeLit = isNodeLit || _isNodeLit[crossing] != 0;
            for (const StreetArm& arm : _graph.crossings[crossing].arms)
                if (isInner(arm.chain))
                    armAt(arm.chain, arm.isEnd) = {};
                else if (leadsIn(arm))
                {
                    leading.push_back(arm);
                    lit += armAt(arm.chain, arm.isEnd).isLit ? 1 : 0;
                }
        }
        if (isNodeLit || (lit >= 2 && 2 * lit >= leading.size()))
        {
            for (const std::size_t crossing : crossings)
                _plan.placeOf[crossing] = _plan.places;
            ++_plan.places;
            for (const StreetArm& arm : leading)
            {
                const int crossing = crossingAt(arm.chain, arm.isEnd);
                if (traitsAtEnd(arm).kind != "service" || _isNodeLit[static_cast<std::size_t>(crossing)] != 0)
                    armAt(arm.chain, arm.isEnd).isLit = true;
            }
            return;
        }
        for (const StreetArm& arm : leading) // a light of one arm alone is not the crossing's
        {
            ArmSignals& signals = armAt(arm.chain, arm.isEnd);
            if (!signals.isLit) continue;
            const double beforeM = signals.footM.value_or(signals.lineM.value_or(0.0));
            const bool isFoot = signals.footM.has_value();
            addBetween(arm.chain, arm.isEnd ? lengthM(arm.chain) - beforeM : beforeM, isFoot || arm.isEnd,
                       isFoot || !arm.isEnd, isFoot);
            signals = {};
        }
    }

    /// Whether people who cross so near before a crossing cross with its lights.
    bool crossesWith(const WaitNode& node, bool isEnd)
    {
        return toEndM(node, isEnd) <= kLightNearerM && isLitCrossing(crossingAt(node.chain, isEnd)) &&
               (armAt(node.chain, isEnd).isLit || !leadsIn({node.chain, isEnd}));
    }

    void takeFootLight(const WaitNode& node)
    {
        if (isInner(node.chain)) return;
        bool isEnd = toEndM(node, true) <= toEndM(node, false);
        if (!crossesWith(node, isEnd) && crossesWith(node, !isEnd)) isEnd = !isEnd;
        ArmSignals& arm = armAt(node.chain, isEnd);
        if (!crossesWith(node, isEnd))
            addBetween(node.chain, node.atM, true, true, true);
        else if (!arm.footM)
            arm.footM = toEndM(node, isEnd);
    }

    void takeSign(const WaitNode& node)
    {
        const int direction = directionOf(node);
        if (direction == 0 || toEndM(node, direction > 0) > kLightAheadM) return;
        ArmSignals& arm = armAt(node.chain, direction > 0);
        if (arm.isLit || !leadsIn({node.chain, direction > 0}) || isInner(node.chain)) return;
        arm.sign = node.tags.isStop ? ArmSignals::Sign::stop : ArmSignals::Sign::giveWay;
        arm.lineM = toEndM(node, direction > 0);
    }

    const StreetMap& _map;
    const StreetGraph& _graph;
    const std::vector<CentreLine>& _lines;
    const std::vector<ChainCut>& _cuts;
    std::vector<WaitNode> _nodes;
    std::vector<char> _isNodeLit;
    std::vector<std::size_t> _root; ///< crossings of one programme
    SignalPlan _plan;
};

} // namespace

SignalPlan signalPlanOf(const StreetMap& map, const StreetGraph& graph, const std::vector<CentreLine>& lines,
                        const std::vector<ChainCut>& cuts)
{
    return SignalPlanner(map, graph, lines, cuts).plan();
}

} // namespace worldmaking
