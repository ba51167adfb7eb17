// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <foundation/Angle.h>

#include <osgRoads/core/query/ChooseDrive.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr double kStartShare = 0.5; ///< of the length, at most, lies on the first lane if another follows
constexpr double kJunctionWorthM = 60.0;  ///< metres of drive that a junction counts as
constexpr int kMostJunctions = 3;         ///< that count
constexpr double kOutermostWorthM = 20.0; ///< and for the outermost driving lane as the start
constexpr double kVisitedTurnRad = 10.0;  ///< a lane that was driven is the last choice

/// A lane that is driven, and whether it was entered from the side.
struct Step
{
    std::uint32_t lane = 0;
    bool isLaneChange = false;
};

class DriveSearch
{
public:
    DriveSearch(const RoadNetwork& network, const LaneGraph& graph, double lengthM)
        : _network(network), _graph(graph), _lengthM(lengthM)
    {
    }

    LaneRoute best() const
    {
        std::vector<Step> chosen;
        double most = -std::numeric_limits<double>::infinity();
        for (std::uint32_t lane = 0; lane < _graph.lanes().size(); ++lane)
        {
            const std::vector<Step> steps = stepsFrom(lane);
            const double worth = worthOf(steps);
            if (worth <= most) continue;
            most = worth;
            chosen = steps;
        }
        return routeOver(chosen);
    }

private:
    const Road& roadOf(const LaneKey& key) const
    {
        return _network.roads[static_cast<std::size_t>(key.road)];
    }

    const LaneSection& sectionOf(const LaneKey& key) const
    {
        return roadOf(key).sections[static_cast<std::size_t>(key.section)];
    }

    /// The heading of a lane's traffic where it begins or ends.
    double headingAt(const LaneKey& key, bool atEnd) const
    {
        const LaneSection& section = sectionOf(key);
        const double s = atEnd == key.isForward ? section.end : section.s;
        return frameAt(roadOf(key), s).headingRad + (key.isForward ? 0.0 : std::acos(-1.0));
    }

    /// How much a lane turns; connecting roads turn from their start to their end.
    double turnOf(std::uint32_t lane) const
    {
        const LaneKey& key = _graph.lanes()[lane];
        return std::fabs(foundation::wrappedRad(headingAt(key, true) - headingAt(key, false)));
    }

    bool goesOn(std::uint32_t lane) const
    {
        const auto& edges = _graph.edges(lane);
        return std::any_of(edges.begin(), edges.end(),
                           [](const LaneGraph::Edge& edge) { return !edge.isLaneChange; });
    }

    std::optional<Step> next(const std::vector<Step>& steps) const
    {
        std::optional<Step> chosen;
        double least = std::numeric_limits<double>::infinity();
        for (const LaneGraph::Edge& edge : _graph.edges(steps.back().lane))
        {
            // Sideways only where the lane ends and the one beside it does not.
            if (edge.isLaneChange && (goesOn(steps.back().lane) || !goesOn(edge.to))) continue;
            const bool wasDriven = std::any_of(steps.begin(), steps.end(),
                                               [&](const Step& step) { return step.lane == edge.to; });
            if (edge.isLaneChange && wasDriven) continue;
            const double turn = turnOf(edge.to) + (wasDriven ? kVisitedTurnRad : 0.0);
            if (turn >= least) continue;
            least = turn;
            chosen = Step{edge.to, edge.isLaneChange};
        }
        return chosen;
    }

    std::vector<Step> stepsFrom(std::uint32_t lane) const
    {
        std::vector<Step> steps{{lane, false}};
        double driven = std::min(_graph.lengthM(lane), kStartShare * _lengthM);
        while (driven < _lengthM)
        {
            const std::optional<Step> step = next(steps);
            const double length = step ? _graph.lengthM(step->lane) : 0.0;
            if (!step || steps.size() > kMostSteps) break;
            driven += length - (step->isLaneChange ? _graph.lengthM(steps.back().lane) : 0.0);
            steps.push_back(*step);
        }
        return steps;
    }

    bool isOutermost(const LaneKey& key) const
    {
        const Lane* outer = sectionOf(key).lane(key.lane + (key.lane > 0 ? 1 : -1));
        return !outer || !isForCars(outer->type);
    }

    double fullLengthM(const std::vector<Step>& steps) const
    {
        double length = 0.0;
        for (std::size_t i = 0; i < steps.size(); ++i)
            if (i + 1 == steps.size() || !steps[i + 1].isLaneChange) length += _graph.lengthM(steps[i].lane);
        return length;
    }

    double worthOf(const std::vector<Step>& steps) const
    {
        const LaneKey& first = _graph.lanes()[steps.front().lane];
        int junctions = 0;
        for (std::size_t i = 1; i < steps.size(); ++i)
            junctions += roadOf(_graph.lanes()[steps[i].lane]).junction >= 0 ? 1 : 0;
        const bool beginsWell = roadOf(first).junction < 0 && isOutermost(first) &&
                                sectionOf(first).lane(first.lane)->type == LaneType::driving;
        return std::min(fullLengthM(steps), _lengthM) +
               kJunctionWorthM * std::min(junctions, kMostJunctions) + (beginsWell ? kOutermostWorthM : 0.0);
    }

    LaneRoute routeOver(const std::vector<Step>& steps) const
    {
        LaneRoute route;
        for (std::size_t i = 0; i < steps.size(); ++i)
        {
            const LaneKey& key = _graph.lanes()[steps[i].lane];
            const LaneSection& section = sectionOf(key);
            RouteLeg leg{key, section.s, section.end, steps[i].isLaneChange};
            if (!key.isForward) std::swap(leg.sFrom, leg.sTo);
            if (i + 1 < steps.size() && steps[i + 1].isLaneChange) leg.sTo = leg.sFrom;
            route.legs.push_back(leg);
            route.lengthM += std::fabs(leg.sTo - leg.sFrom);
        }
        if (route.legs.empty()) return route;
        // What is too long is left out at the start, where the first lane has it, else at the end.
        RouteLeg& first = route.legs.front();
        const double firstM = std::fabs(first.sTo - first.sFrom);
        const double keepM =
            route.legs.size() > 1 ? std::min(firstM, kStartShare * _lengthM) : std::min(firstM, _lengthM);
        const double dropM = std::min(firstM - keepM, std::max(route.lengthM - _lengthM, 0.0));
        first.sFrom += first.lane.isForward ? dropM : -dropM;
        route.lengthM -= dropM;
        return route;
    }

    static constexpr std::size_t kMostSteps = 1000; ///< a ring of lanes without length would have no end

    const RoadNetwork& _network;
    const LaneGraph& _graph;
    double _lengthM;
};

} // namespace

LaneRoute chooseDrive(const RoadNetwork& network, const LaneGraph& graph, double lengthM)
{
    return DriveSearch(network, graph, lengthM).best();
}

} // namespace osgRoads::core
