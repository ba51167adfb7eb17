// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenSCENARIO XML 1.3, TrafficAreaAction. A point in a polygon: Shimrat, "Algorithm 112:
// position of point relative to polygon", Communications of the ACM 5, 1962.
#include <algorithm>

#include "simulation/player/traffic/TrafficFlow.h"

namespace simulation
{
namespace
{

constexpr double kAreaPauseS = 0.5; ///< before the next attempt where there was no room

bool isInside(const std::vector<glm::dvec2>& corners, const glm::dvec2& point)
{
    bool inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
    {
        const glm::dvec2 &a = corners[i], &b = corners[j];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

/// Vehicles appear in the area; in a continuous one those that have left it vanish, and others appear.
class AreaFlow final : public TrafficFlow
{
public:
    AreaFlow(const TrafficArea& area, const std::vector<int>& vehicles, RandomDraw draw)
        : _area(area), _vehicles(vehicles), _draw(std::move(draw))
    {
    }

    void step(TrafficScene& scene) override
    {
        const bool isFirst = !_begun;
        if (isFirst) begin(scene);
        if (!isFirst && !_area.isContinuous) return;
        for (const int vehicle : _vehicles)
        {
            if (!scene.isPresent(vehicle)) continue;
            const EntityState& state = scene.motion(vehicle).state();
            if (state.place && !contains(scene, *state.place, state.position)) scene.vanish(vehicle);
        }
        if (scene.timeS() >= _nextS) fill(scene);
    }

private:
    void begin(TrafficScene& scene)
    {
        _begun = true;
        for (const Position& corner : _area.corners)
            if (const auto placed = scene.positions().place(corner)) _corners.emplace_back(placed->position);
        for (const LaneSite& site : scene.laneSites())
            if (contains(scene, site.place, site.position)) _sites.push_back(&site);
    }

    bool contains(TrafficScene& scene, const RoadPlace& place, const glm::dvec3& point) const
    {
        if (!_corners.empty()) return isInside(_corners, glm::dvec2(point));
        const auto holds = [&](const RoadStretch& stretch)
        {
            const bool isOnIt = scene.roads()->roadAt(place).id == stretch.roadId &&
                                place.s >= stretch.fromM && (!stretch.toM || place.s <= *stretch.toM);
            return isOnIt && (stretch.lanes.empty() || std::find(stretch.lanes.begin(), stretch.lanes.end(),
                                                                 place.lane) != stretch.lanes.end());
        };
        return std::any_of(_area.stretches.begin(), _area.stretches.end(), holds);
    }

    void fill(TrafficScene& scene)
    {
        for (int vehicle = absentOf(scene, _vehicles); vehicle >= 0; vehicle = absentOf(scene, _vehicles))
        {
            const LaneSite* const site = pickSite(scene, vehicle, _sites, _draw);
            if (!site)
            {
                _nextS = scene.timeS() + kAreaPauseS;
                return;
            }
            scene.appear(vehicle, site->place, defaultSpeed(scene, vehicle, site->place));
        }
    }

    TrafficArea _area;
    std::vector<int> _vehicles;
    RandomDraw _draw;
    bool _begun = false;
    std::vector<glm::dvec2> _corners;
    std::vector<const LaneSite*> _sites;
    double _nextS = 0.0;
};

} // namespace

std::unique_ptr<TrafficFlow> makeFlow(const TrafficArea& area, const std::vector<int>& vehicles,
                                      RandomDraw draw)
{
    return std::make_unique<AreaFlow>(area, vehicles, std::move(draw));
}

} // namespace simulation
