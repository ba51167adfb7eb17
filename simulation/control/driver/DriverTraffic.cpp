// SPDX-License-Identifier: Apache-2.0
// Whom and what a driver meets on the way: others, signs, lights, the end; and how it passes slower ones.
#include <algorithm>
#include <cmath>

#include "simulation/control/driver/Driver.h"
#include "simulation/road/StopSignals.h"

namespace simulation
{

namespace
{

constexpr double kBesideM = 1.7;      ///< from the middle of the own lane, within which others are in the way
constexpr double kAsideMps = 1.2;     ///< of a change of lane
constexpr double kAheadAgainM = 12.0; ///< between both when an overtaker comes back

double lengthAhead(const RoadVehicleData& data)
{
    const HullBox& box = data.hull.boxes.front();
    return box.place.x + 0.5 * box.sizeM.x;
}

} // namespace

void Driver::lookAtStops(const ControlView& view, double speedMps, Ahead& ahead)
{
    const double front = _beside.alongM + lengthAhead(_vehicle.data());
    const std::vector<DriverStop>& stops = _path.stops();
    while (_nextStop < stops.size() && stops[_nextStop].atM < front - 2.0)
        ++_nextStop;
    if (_nextStop < stops.size())
    {
        const DriverStop& stop = stops[_nextStop];
        const double gap = stop.atM - front;
        constexpr double kBrakes = 2.0; // of the comfortable deceleration, for a line that comes late
        const bool holds = !comesTooLate(gap, speedMps, kBrakes * _settings.brakeMps2) &&
                           (stop.signal.empty() ? _signs.holds(stop.atM, gap, speedMps, RoadVehicle::kStepS)
                                                : view.traffic.signalStates &&
                                                      holdsBack(*view.traffic.signalStates, stop.signal));
        if (holds && gap + _settings.gapM - 1.0 < ahead.gapM)
        {
            ahead = {gap + _settings.gapM - 1.0, 0.0};
            _phase = "stop";
        }
    }
    if (_settings.stopsAtEnd)
    {
        const double gap = _path.lengthM() - front + _settings.gapM - 1.0;
        if (gap < ahead.gapM) ahead = {gap, 0.0};
        if (_path.lengthM() - front < 3.0 && speedMps < kStandsMps) _isDone = true;
    }
    else if (front > _path.lengthM() - 1.0)
        _isDone = true;
}

/// Who drives ahead, on the way moved aside by an offset.
Driver::Ahead Driver::lookAtOthers(const ControlView& view, double offsetM) const
{
    Ahead ahead;
    const double front = _beside.alongM + lengthAhead(_vehicle.data());
    for (std::size_t i = 0; i < view.traffic.entities.size(); ++i)
    {
        const EntityState& other = view.traffic.entities[i];
        if (static_cast<int>(i) == view.traffic.own || !other.isPresent) continue;
        if (glm::length(glm::dvec2(other.position - view.state.position)) > kSeenM) continue;
        const DriverPath::Beside beside =
            _path.nearest(other.position, _beside.alongM + 0.5 * kSeenM, 0.5 * kSeenM + kReachM);
        if (beside.alongM < _beside.alongM || std::abs(beside.offsetM - offsetM) > kBesideM) continue;
        const double halfLength = i < view.traffic.boxes.size() ? 0.5 * view.traffic.boxes[i].lengthM : 2.0;
        const double middle = i < view.traffic.boxes.size() ? view.traffic.boxes[i].centre.x : 1.4;
        const double heading = _path.headingRadAt(beside.alongM);
        const double gap = beside.alongM + middle - halfLength - front;
        if (gap > ahead.gapM) continue;
        ahead = {gap, other.velocity.x * std::cos(heading) + other.velocity.y * std::sin(heading)};
    }
    return ahead;
}

/// Goes to the left of a slower vehicle when nobody is there, and comes back ahead of it.
void Driver::considerOvertaking(const ControlView& view, double speedMps)
{
    const Ahead own = lookAtOthers(view, 0.0);
    const bool isOut = _wantedOffsetM != 0.0 && !_isLed;
    const double wish = wantedSpeed(speedMps);
    if (!isOut && !_isLed && _settings.overtakes && own.gapM < 40.0 && own.speedMps < 0.8 * wish)
    {
        const Ahead left = lookAtOthers(view, _settings.overtakeOffsetM);
        const double needed = 60.0 + 12.0 * std::max(0.0, speedMps - left.speedMps);
        if (left.gapM > needed) _wantedOffsetM = _settings.overtakeOffsetM;
    }
    // Back when nobody of the own lane is beside or just ahead.
    if (isOut && own.gapM > 40.0)
    {
        bool isClear = true;
        for (std::size_t i = 0; i < view.traffic.entities.size(); ++i)
        {
            const EntityState& other = view.traffic.entities[i];
            if (static_cast<int>(i) == view.traffic.own || !other.isPresent) continue;
            isClear = isClear && glm::length(glm::dvec2(other.position - view.state.position)) > kAheadAgainM;
        }
        if (isClear) _wantedOffsetM = 0.0;
    }
    if (_isLed) return;
    const double most = kAsideMps * RoadVehicle::kStepS;
    _offsetM += std::clamp(_wantedOffsetM - _offsetM, -most, most);
}

Driver::Ahead Driver::nearestAhead(const ControlView& view, double speedMps)
{
    _phase = _wantedOffsetM != 0.0 ? "overtake" : "drive";
    Ahead ahead = lookAtOthers(view, _wantedOffsetM);
    if (ahead.gapM < 50.0) _phase = "follow";
    lookAtStops(view, speedMps, ahead);
    return ahead;
}

} // namespace simulation
