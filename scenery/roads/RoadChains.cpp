// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/RoadChains.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

namespace scenery
{

namespace
{

using osgRoads::core::ContactPoint;
using osgRoads::core::JunctionType;
using osgRoads::core::Road;
using osgRoads::core::RoadLink;
using osgRoads::core::RoadNetwork;

constexpr double kGapM = 5.0; ///< between linked ends, along the road: wider ones are a mistake in the file

/// Sets of ends of roads and of junctions that meet in one place.
class Meetings
{
public:
    explicit Meetings(const RoadNetwork& network)
        : _network(network),
          _parents(2 * network.roads.size() + network.junctions.size()),
          _isArea(_parents.size()),
          _isInside(network.roads.size()),
          _linkedBack(2 * network.roads.size(), -1)
    {
        std::iota(_parents.begin(), _parents.end(), 0);
        for (std::size_t i = 0; i < network.junctions.size(); ++i)
            _isArea[2 * network.roads.size() + i] = true;
        for (int i = 0; i < count(); ++i)
            if (road(i).isUsable) addRoad(i);
        addCrowdedLinks();
        addShortRoads();
    }

    int count() const { return static_cast<int>(_network.roads.size()); }
    const Road& road(int index) const { return _network.roads[static_cast<std::size_t>(index)]; }
    bool isInside(int road) const { return _isInside[static_cast<std::size_t>(road)]; }
    static int endOf(int road, bool isEnd) { return 2 * road + (isEnd ? 1 : 0); }

    int rootOf(int end) const
    {
        while (_parents[static_cast<std::size_t>(end)] != end)
            end = _parents[static_cast<std::size_t>(end)];
        return end;
    }
    bool isArea(int end) const { return _isArea[static_cast<std::size_t>(rootOf(end))]; }
    void makeArea(int end) { _isArea[static_cast<std::size_t>(rootOf(end))] = true; }

    /// Returns the other end that is linked to an end that is in no area.
    std::optional<int> linkedTo(int end) const
    {
        const Road& from = road(end / 2);
        const auto linked = linkedEnd(end, end % 2 == 1 ? from.successor : from.predecessor);
        if (linked && *linked != end) return linked;
        return _linkedBack[static_cast<std::size_t>(end)] >= 0
                   ? std::optional<int>(_linkedBack[static_cast<std::size_t>(end)])
                   : std::nullopt;
    }

private:
    void unite(int a, int b)
    {
        const int from = rootOf(a), to = rootOf(b);
        _isArea[static_cast<std::size_t>(to)] =
            _isArea[static_cast<std::size_t>(to)] || _isArea[static_cast<std::size_t>(from)];
        for (const int node : {a, b, from}) // short ways to the root
            _parents[static_cast<std::size_t>(node)] = to;
    }

    /// The end of a usable road to which a link at an end leads, or the node of a junction.
    std::optional<int> linkedEnd(int end, const std::optional<RoadLink>& link) const
    {
        if (!link || link->index < 0 || link->elementS) return std::nullopt;
        if (link->isJunction) return 2 * count() + link->index;
        if (!road(link->index).isUsable) return std::nullopt;
        const int linked = endOf(link->index, link->contactPoint == ContactPoint::end);
        return areOneBehindTheOther(end, linked) ? std::optional<int>(linked) : std::nullopt;
    }

    /// Whether the cross-sections of two ends lie in one line, whatever their places across.
    bool areOneBehindTheOther(int a, int b) const
    {
        const auto at = [this](int end)
        { return road(end / 2).referenceLine.at(end % 2 == 1 ? road(end / 2).length : 0.0); };
        const auto line = at(a);
        return std::abs(glm::dot(at(b).position - line.position, line.tangent())) < kGapM;
    }

    void addRoad(int index)
    {
        const Road& added = road(index);
        if (added.junction >= 0) putInside(index);
        const bool isOfVirtual =
            added.junction >= 0 &&
            _network.junctions[static_cast<std::size_t>(added.junction)].type == JunctionType::isVirtual;
        if (added.junction >= 0 && !isOfVirtual) unite(endOf(index, false), 2 * count() + added.junction);
        addLink(endOf(index, false), added.predecessor);
        addLink(endOf(index, true), added.successor);
    }

    void putInside(int index)
    {
        _isInside[static_cast<std::size_t>(index)] = true;
        unite(endOf(index, false), endOf(index, true));
        makeArea(endOf(index, false));
    }

    void addLink(int end, const std::optional<RoadLink>& link)
    {
        const auto linked = linkedEnd(end, link);
        if (!linked) return;
        unite(end, *linked);
        if (*linked < 2 * count()) _linkedBack[static_cast<std::size_t>(*linked)] = end;
    }

    /// More than two ends in one place are an area.
    void addCrowdedLinks()
    {
        std::vector<int> ends(_parents.size());
        for (int i = 0; i < count(); ++i)
            for (const bool isEnd : {false, true})
                if (road(i).isUsable && ++ends[static_cast<std::size_t>(rootOf(endOf(i, isEnd)))] > 2)
                    makeArea(endOf(i, isEnd));
    }

    void addShortRoads()
    {
        for (int i = 0; i < count(); ++i)
            if (road(i).isUsable && !isInside(i) && road(i).length < kShortRoadM && isArea(endOf(i, false)) &&
                isArea(endOf(i, true)))
                putInside(i);
    }

    const RoadNetwork& _network;
    std::vector<int> _parents; ///< of 2 · road (+ 1 for its end), then of junctions
    std::vector<bool> _isArea; ///< of roots
    std::vector<bool> _isInside;
    std::vector<int> _linkedBack; ///< of an end: one that is linked to it; -1: none
};

/// Follows the links from an end of a road, which the chain leaves by the other one.
RoadChain chainFrom(const Meetings& meetings, int entry, std::vector<bool>& isTaken)
{
    RoadChain chain;
    for (std::optional<int> in = entry; in && !isTaken[static_cast<std::size_t>(*in / 2)];)
    {
        const int road = *in / 2, out = *in ^ 1;
        isTaken[static_cast<std::size_t>(road)] = true;
        chain.links.push_back({road, *in % 2 == 1, chain.lengthM});
        chain.lengthM += meetings.road(road).length;
        in = meetings.isArea(out) ? std::nullopt : meetings.linkedTo(out);
    }
    return chain;
}

} // namespace

RoadChains chainsOf(const RoadNetwork& network)
{
    Meetings meetings(network);
    RoadChains parts;
    std::vector<bool> isTaken(network.roads.size());
    const auto isFree = [&](int road)
    {
        return meetings.road(road).isUsable && !meetings.isInside(road) &&
               !isTaken[static_cast<std::size_t>(road)];
    };
    const auto startAt = [&](int end) { parts.chains.push_back(chainFrom(meetings, end, isTaken)); };
    for (int i = 0; i < meetings.count(); ++i)
        for (const int end : {Meetings::endOf(i, false), Meetings::endOf(i, true)})
            if (isFree(i) && (meetings.isArea(end) || !meetings.linkedTo(end))) startAt(end);
    for (int i = 0; i < meetings.count(); ++i) // rings
        if (isFree(i))
        {
            meetings.makeArea(Meetings::endOf(i, false));
            startAt(Meetings::endOf(i, false));
        }

    std::vector<int> areaOf(2 * network.roads.size() + network.junctions.size(), -1);
    const auto areaAt = [&](int end)
    {
        if (!meetings.isArea(end)) return -1;
        int& area = areaOf[static_cast<std::size_t>(meetings.rootOf(end))];
        if (area < 0)
        {
            area = static_cast<int>(parts.areas.size());
            parts.areas.emplace_back();
        }
        return area;
    };
    for (int i = 0; i < meetings.count(); ++i)
        if (meetings.road(i).isUsable && meetings.isInside(i))
            parts.areas[static_cast<std::size_t>(areaAt(Meetings::endOf(i, false)))].inside.push_back(i);
    for (RoadChain& chain : parts.chains)
    {
        const RoadChain::Link &first = chain.links.front(), &last = chain.links.back();
        chain.startArea = areaAt(Meetings::endOf(first.road, first.isReversed));
        chain.endArea = areaAt(Meetings::endOf(last.road, !last.isReversed));
        if (chain.startArea >= 0)
            parts.areas[static_cast<std::size_t>(chain.startArea)].arms.push_back(
                {first.road, first.isReversed});
        if (chain.endArea >= 0)
            parts.areas[static_cast<std::size_t>(chain.endArea)].arms.push_back(
                {last.road, !last.isReversed});
    }
    return parts;
}

} // namespace scenery
