// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/WaterWorks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <glm/glm.hpp>

#include "scenery/buildings/Outline.h"
#include "worldmaking/earth/WaterArea.h"
#include "worldmaking/earth/WaterLevels.h"
#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/OgrPolygon.h"
#include "worldmaking/map/WaterTags.h"
#include "worldmaking/plan/Waters.h"

namespace worldmaking
{

namespace
{

using osgTerrainROAM::core::Earthwork;

constexpr double kRiverStepM = 25.0; ///< between the points of a river
constexpr double kBankReachM = 12.0; ///< the lowest ground so far beside a river counts
constexpr double kSunkM = 0.3;       ///< below the ground
constexpr double kShore = 0.25;      ///< of the shores that reach to the ground
constexpr double kBank = 0.8;        ///< of a river's banks
constexpr double kRiseM = 0.5;
constexpr double kShoreShare = 0.05; ///< of the shore's ground is lower than a lake
constexpr double kLakeTouchM = 1.0;  ///< between areas of one lake, at most
constexpr double kBedM = 2.0;        ///< a bed is wider than what is painted
constexpr std::size_t kPiece = 6;    ///< points of a river of one width

/// A river's line, by nodes of the net.
struct River
{
    std::vector<glm::dvec2> line;
    std::vector<std::uint32_t> nodes;
    double widthM = 0.0;
};

/// Collects areas and rivers, and joins them to a net.
class WaterMaker
{
public:
    WaterMaker(const MapPlane& plane, const foundation::HeightInPlan& ground, WaterReport& report)
        : _plane(plane), _ground(ground), _report(report)
    {
    }

    void addArea(const LandShape& shape)
    {
        auto rings = _plane.toPlan(shape.paths);
        auto shore = rings ? shoreOf(*rings, _ground) : std::nullopt;
        if (!shore)
        {
            ++_report.beyondGround;
            return;
        }
        WaterArea area{std::move(*rings), std::move(*shore), isRiverArea(shape.tags)};
        const WaterArea* const same = touching(area);
        area.node = same ? same->node : node(area.shareM(kShoreShare));
        _net.groundM[area.node] = std::min(_net.groundM[area.node], area.shareM(kShoreShare));
        _grid.add(_areas.size(), boxOf(area.rings.front()));
        _areas.push_back(std::move(area));
    }

    /// All areas must have been added.
    void addRiver(const LandShape& shape, double widthM)
    {
        const auto path = _plane.toPlan(shape.paths);
        if (!path || path->front().size() < 2)
        {
            ++_report.beyondGround;
            return;
        }
        River river{{}, {}, widthM};
        for (std::size_t i = 0; i + 1 < path->front().size(); ++i)
        {
            const glm::dvec2 a = path->front()[i], b = path->front()[i + 1];
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / kRiverStepM)));
            for (int step = i == 0 ? 0 : 1; step <= steps; ++step)
                addPoint(glm::mix(a, b, static_cast<double>(step) / steps), b - a, river);
        }
        if (river.nodes.size() > 1) _rivers.push_back(std::move(river));
    }

    std::vector<Earthwork> works()
    {
        const std::vector<double> levels = spreadFalls(_net, waterLevels(_net));
        std::vector<Earthwork> made;
        for (std::size_t i = 0; i < _rivers.size(); ++i)
            addRiverWorks(_rivers[i], static_cast<int>(i) + 1, levels, made);
        _report.rivers = _rivers.size();
        for (const WaterArea& area : _areas)
        {
            const bool hasLine = area.isRiver && _flowsThrough[area.node];
            if (hasLine) continue; // its rivers lie as wide
            if (!area.isLevel())
            {
                ++_report.unlevelled;
                continue;
            }
            Earthwork work;
            work.isArea = true;
            work.paths = area.rings;
            for (const auto& ring : area.rings)
                work.heightsM.emplace_back(ring.size(), levels[area.node]);
            work.slope = kShore;
            work.riseM = kRiseM;
            made.push_back(std::move(work));
            ++_report.lakes;
        }
        return made;
    }

private:
    std::uint32_t node(double groundM)
    {
        _net.groundM.push_back(groundM);
        _flowsThrough.push_back(0);
        return static_cast<std::uint32_t>(_net.groundM.size() - 1);
    }

    /// An area that is part of the same lake as another, since they touch: of maps that draw a lake in
    /// pieces.
    const WaterArea* touching(const WaterArea& area) const
    {
        const WaterArea* found = nullptr;
        const MapBox box = boxOf(area.rings.front());
        const auto polygon = polygonOf(area.rings);
        _grid.near({box.low - kLakeTouchM, box.high + kLakeTouchM},
                   [&](std::size_t i)
                   {
                       if (found || area.isRiver || _areas[i].isRiver) return;
                       if (polygon->Distance(polygonOf(_areas[i].rings).get()) < kLakeTouchM)
                           found = &_areas[i];
                   });
        return found;
    }

    const WaterArea* areaAt(const glm::dvec2& place) const
    {
        const WaterArea* found = nullptr;
        _grid.near({place, place}, [&](std::size_t i)
                   { found = !found && scenery::isWithin(_areas[i].rings, place) ? &_areas[i] : found; });
        return found;
    }

    /// The lowest ground beside a point of a river.
    std::optional<double> lowGroundM(const glm::dvec2& place, const glm::dvec2& along) const
    {
        const double lengthM = std::max(glm::length(along), 1e-9);
        const glm::dvec2 left = kBankReachM / lengthM * glm::dvec2(-along.y, along.x);
        std::optional<double> lowM;
        for (const double side : {0.0, -1.0, 1.0})
            if (const auto height = _ground(place + side * left))
                lowM = std::min(lowM.value_or(1e300), *height);
        return lowM;
    }

    void addPoint(const glm::dvec2& place, const glm::dvec2& along, River& river)
    {
        const WaterArea* const area = areaAt(place);
        std::optional<std::uint32_t> its;
        if (area && !area->isRiver) its = area->node;
        if (area && area->isRiver) _flowsThrough[area->node] = 1;
        if (!its)
        {
            const auto lowM = lowGroundM(place, along);
            if (!lowM) return;
            const auto [found, isNew] =
                _places.try_emplace(std::pair(std::llround(20.0 * place.x), std::llround(20.0 * place.y)));
            if (isNew) found->second = node(*lowM - kSunkM);
            its = found->second;
        }
        if (!river.nodes.empty() && river.nodes.back() != *its)
        {
            _net.flows.emplace_back(river.nodes.back(), *its);
            _net.flowsM.push_back(glm::distance(river.line.back(), place));
        }
        river.line.push_back(place);
        river.nodes.push_back(*its);
    }

    /// The width of the bed at a place of a river: within its area as wide as the nearest shore allows.
    double widthAt(const glm::dvec2& place, double otherwiseM) const
    {
        const WaterArea* const area = areaAt(place);
        return area && area->isRiver ? std::clamp(2.4 * shoreDistanceM(area->rings, place), otherwiseM, 200.0)
                                     : otherwiseM;
    }

    bool isLake(std::uint32_t node) const
    {
        return std::any_of(_areas.begin(), _areas.end(),
                           [=](const WaterArea& area) { return area.node == node && !area.isRiver; });
    }

    /// Pieces of one width each; nothing where both ends lie in a lake.
    void addRiverWorks(const River& river, int number, const std::vector<double>& levels,
                       std::vector<Earthwork>& made)
    {
        for (std::size_t from = 0; from + 1 < river.line.size(); from += kPiece)
        {
            const std::size_t to = std::min(from + kPiece, river.line.size() - 1);
            Earthwork work;
            work.paths.emplace_back();
            work.heightsM.emplace_back();
            work.slope = kBank;
            work.riseM = kRiseM;
            work.river = number;
            work.widthM = 0.0;
            std::size_t inLake = 0;
            for (std::size_t i = from; i <= to; ++i)
            {
                work.paths.front().push_back(river.line[i]);
                work.heightsM.front().push_back(levels[river.nodes[i]]);
                work.widthM = std::max(work.widthM, widthAt(river.line[i], river.widthM) + kBedM);
                inLake += isLake(river.nodes[i]);
            }
            if (inLake < work.paths.front().size()) made.push_back(std::move(work));
        }
    }

    const MapPlane& _plane;
    const foundation::HeightInPlan& _ground;
    WaterReport& _report;
    WaterNet _net;
    std::vector<char> _flowsThrough; ///< by node: a river's line lies in that area
    std::vector<WaterArea> _areas;
    std::vector<River> _rivers;
    PlanGrid _grid;
    std::map<std::pair<long long, long long>, std::uint32_t> _places;
};

} // namespace

std::vector<Earthwork> waterWorks(const LandMap& map, const MapPlane& plane,
                                  const foundation::HeightInPlan& ground, WaterReport& report)
{
    const GdalScope quiet;
    WaterMaker maker(plane, ground, report);
    for (const LandShape& shape : map.shapes)
        if (isWater(shape)) maker.addArea(shape);
    for (const LandShape& shape : map.shapes)
        if (const auto widthM = riverWidthM(shape)) maker.addRiver(shape, *widthM);
    return maker.works();
}

} // namespace worldmaking
