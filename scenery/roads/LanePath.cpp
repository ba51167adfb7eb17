// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/LanePath.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <osgRoads/core/geometry/Cubic.h>
#include <osgRoads/core/query/LaneSpan.h>

namespace scenery
{

namespace
{

using osgRoads::core::Road;

constexpr double kHalfWayM = 1.25; ///< half of what a car needs
constexpr double kInsideM = 1e-6;  ///< the end of a lane is asked for so far inside its section

/// Speeds where a file tells none, m/s. They are usual limits: 120, 80 and 50 km/h.
constexpr double kMotorwayMps = 33.3, kRuralMps = 22.2, kTownMps = 13.9;

double limitOf(const Road& road, double s)
{
    const int index = osgRoads::core::lastStartingBy(road.kinds, s);
    if (index < 0) return kTownMps;
    const osgRoads::core::RoadKind& kind = road.kinds[static_cast<std::size_t>(index)];
    if (kind.metresPerSecond) return *kind.metresPerSecond;
    if (kind.type == "motorway") return kMotorwayMps;
    return kind.type == "rural" ? kRuralMps : kTownMps;
}

/// The way from the middles of lanes to the path, which vanishes within kBlendWayM of where lanes did not
/// meet.
class Gap
{
public:
    glm::dvec3 at(double wayM) const
    {
        return _gap * (1.0 - glm::smoothstep(0.0, kBlendWayM, wayM - _openedAtM));
    }

    /// The path has come to `from` on one lane and goes on from `to` on the next.
    void open(const glm::dvec3& from, const glm::dvec3& to, double wayM)
    {
        _gap = at(wayM) + from - to;
        _openedAtM = wayM;
    }

private:
    glm::dvec3 _gap{0.0};
    double _openedAtM = 0.0;
};

/// The middle of a leg's lane.
class LegLine
{
public:
    LegLine(const osgRoads::core::PlacedNetwork& roads, const osgRoads::core::RouteLeg& leg)
        : _roads(roads), _leg(leg)
    {
        const auto& section = road().sections[static_cast<std::size_t>(leg.lane.section)];
        _lowest = section.s;
        _highest = std::max(section.s, section.end - kInsideM);
    }

    const Road& road() const { return _roads.road(_leg.lane.road); }
    double lengthM() const { return std::fabs(_leg.sTo - _leg.sFrom); }

    double sAt(double wayM) const
    {
        const double s = _leg.sFrom + (_leg.lane.isForward ? wayM : -wayM);
        return std::clamp(s, _lowest, _highest);
    }

    glm::dvec3 placeAt(double wayM) const
    {
        const double s = sAt(wayM);
        const auto span = osgRoads::core::laneSpan(road(), _leg.lane.lane, s);
        if (!span) return _roads.surfacePoint(_leg.lane.road, s, 0.0);
        // Where a lane narrows to nothing a car keeps off its outer border.
        const double halfM = std::max(0.5 * span->width(), kHalfWayM);
        return _roads.surfacePoint(_leg.lane.road, s, span->outerT + (_leg.lane.lane > 0 ? -halfM : halfM));
    }

private:
    const osgRoads::core::PlacedNetwork& _roads;
    const osgRoads::core::RouteLeg& _leg;
    double _lowest = 0.0, _highest = 0.0;
};

} // namespace

std::vector<LanePathPoint> lanePath(const osgRoads::core::PlacedNetwork& roads,
                                    const osgRoads::core::LaneRoute& route)
{
    std::vector<LanePathPoint> path;
    Gap gap;
    double begunM = 0.0, nextM = 0.0;
    std::optional<glm::dvec3> end; // of the lane before
    for (const osgRoads::core::RouteLeg& leg : route.legs)
    {
        const LegLine line(roads, leg);
        if (end) gap.open(*end, line.placeAt(0.0), begunM);
        for (; nextM <= begunM + line.lengthM(); nextM += kLanePathStepM)
        {
            const double wayM = nextM - begunM;
            path.push_back({line.placeAt(wayM) + gap.at(nextM), limitOf(line.road(), line.sAt(wayM))});
        }
        begunM += line.lengthM();
        end = line.placeAt(line.lengthM());
    }
    return path;
}

double defaultSpeedMps(const osgRoads::core::RoadNetwork& network)
{
    double lengthM = 0.0, sum = 0.0;
    for (const Road& road : network.roads)
    {
        if (!road.isUsable) continue;
        lengthM += road.length;
        sum += road.length * limitOf(road, 0.0);
    }
    return lengthM > 0.0 ? sum / lengthM : kTownMps;
}

} // namespace scenery
