// SPDX-License-Identifier: Apache-2.0
#include "simulation/record/ComparePlaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simulation
{
namespace
{

constexpr double kRunApartM = 0.1;    ///< of two places of a way
constexpr double kShortestRunM = 1.0; ///< that has a direction
constexpr double kRunBackM = 100.0, kRunAheadM = 200.0;

struct RunPoint
{
    double alongM = 0.0, timeS = 0.0;
    MotionSample sample;
};

/// The places of an entity that lie apart, in the order in which it came by.
std::vector<RunPoint> runWay(const MotionTable& table, const MotionTrack& track)
{
    std::vector<RunPoint> way;
    for (std::size_t row = 0; row < track.samples.size(); ++row)
    {
        if (!track.samples[row]) continue;
        const glm::dvec2 here(track.samples[row]->position);
        const double stepM = way.empty() ? 0.0 : glm::distance(glm::dvec2(way.back().sample.position), here);
        if (!way.empty() && stepM < kRunApartM) continue;
        way.push_back({way.empty() ? 0.0 : way.back().alongM + stepM, table.timeS[row], *track.samples[row]});
    }
    return way;
}

/// A place on a way: between the points `leg` and `leg` + 1.
struct RunFoot
{
    std::size_t leg = 0;
    double share = 0.0;     ///< of the leg, 0…1
    double unbounded = 0.0; ///< the same, not cut off at the ends of the leg
    double besideM = 0.0;   ///< to the left
    double distanceM = std::numeric_limits<double>::infinity();
};

RunFoot runFootOn(const std::vector<RunPoint>& way, std::size_t leg, const glm::dvec2& place)
{
    const glm::dvec2 from(way[leg].sample.position), along = glm::dvec2(way[leg + 1].sample.position) - from;
    const double squared = glm::dot(along, along);
    RunFoot foot;
    foot.leg = leg;
    foot.unbounded = glm::dot(place - from, along) / squared;
    foot.share = std::clamp(foot.unbounded, 0.0, 1.0);
    const glm::dvec2 off = place - (from + foot.share * along);
    foot.distanceM = glm::length(off);
    foot.besideM = along.x * off.y - along.y * off.x < 0.0 ? -foot.distanceM : foot.distanceM;
    return foot;
}

RunFoot nearestRunFoot(const std::vector<RunPoint>& way, const glm::dvec2& place, std::size_t first,
                       std::size_t last)
{
    RunFoot best;
    for (std::size_t leg = first; leg < last; ++leg)
        if (const RunFoot foot = runFootOn(way, leg, place); foot.distanceM < best.distanceM) best = foot;
    return best;
}

/// Where a way is met first: on one that comes back, the begin and not the end.
RunFoot firstRunFoot(const std::vector<RunPoint>& way, const glm::dvec2& place)
{
    const std::size_t legs = way.size() - 1;
    const double mostM = 5.0 + 1.5 * nearestRunFoot(way, place, 0, legs).distanceM;
    for (std::size_t leg = 0; leg < legs; ++leg)
    {
        if (runFootOn(way, leg, place).distanceM > mostM) continue;
        const double endM = way[leg].alongM + 4.0 * mostM;
        std::size_t last = leg + 1;
        while (last < legs && way[last].alongM < endM)
            ++last;
        return nearestRunFoot(way, place, leg, last);
    }
    return nearestRunFoot(way, place, 0, legs);
}

/// Where a way goes on that was met last at a place.
RunFoot nextRunFoot(const std::vector<RunPoint>& way, const glm::dvec2& place, double metM, double movedM)
{
    const auto legAt = [&](double alongM)
    {
        const auto after = std::upper_bound(way.begin(), way.end(), alongM,
                                            [](double m, const RunPoint& point) { return m < point.alongM; });
        const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - way.begin() - 1, 0));
        return std::min(index, way.size() - 2);
    };
    return nearestRunFoot(way, place, legAt(metM - kRunBackM), legAt(metM + kRunAheadM + 2.0 * movedM) + 1);
}

/// Collects the differences of one quantity.
class PlaceSum
{
public:
    void add(double difference, double alongM)
    {
        if (_count == 0 || std::fabs(difference) > std::fabs(_spread.largest))
        {
            _spread.largest = difference;
            _spread.largestAtM = alongM;
        }
        _squares += difference * difference;
        ++_count;
    }

    PlaceSpread result() const
    {
        PlaceSpread spread = _spread;
        if (_count > 0) spread.rms = std::sqrt(_squares / static_cast<double>(_count));
        return spread;
    }

private:
    PlaceSpread _spread;
    double _squares = 0.0;
    std::size_t _count = 0;
};

/// Differences along one way.
class AlongRun
{
public:
    explicit AlongRun(const std::vector<RunPoint>& way) : _way(way) {}

    void add(const RunPoint& point)
    {
        const glm::dvec2 place(point.sample.position);
        const RunFoot foot =
            _hasMet ? nextRunFoot(_way, place, _metM, point.alongM - _lastM) : firstRunFoot(_way, place);
        const RunPoint &from = _way[foot.leg], &to = _way[foot.leg + 1];
        _metM = std::lerp(from.alongM, to.alongM, foot.share);
        _lastM = point.alongM;
        _hasMet = true;
        constexpr double kEnd = 1e-9;
        if ((foot.leg == 0 && foot.unbounded < -kEnd) ||
            (foot.leg + 2 == _way.size() && foot.unbounded > 1.0 + kEnd))
        {
            ++_found.beyondRows;
            return;
        }
        compare(point, foot);
    }

    PlaceDifference result(const std::string& entity) const
    {
        PlaceDifference found = _found;
        found.entity = entity;
        found.wayM = _way.back().alongM;
        found.coveredM = found.places > 0 ? _mostM - _leastM : 0.0;
        found.besideM = _beside.result();
        found.heightM = _height.result();
        found.speedMps = _speed.result();
        found.timeS = _time.result();
        if (_hasBank && found.places > 0) found.bankDeg = _bank.result();
        return found;
    }

private:
    void compare(const RunPoint& point, const RunFoot& foot)
    {
        const RunPoint &from = _way[foot.leg], &to = _way[foot.leg + 1];
        const auto wanted = [&](auto member) { return std::lerp(member(from), member(to), foot.share); };
        ++_found.places;
        _leastM = std::min(_leastM, _metM);
        _mostM = std::max(_mostM, _metM);
        _beside.add(foot.besideM, _metM);
        _height.add(point.sample.position.z - wanted([](const RunPoint& at) { return at.sample.position.z; }),
                    _metM);
        _speed.add(point.sample.speedMps - wanted([](const RunPoint& at) { return at.sample.speedMps; }),
                   _metM);
        _time.add(point.timeS - wanted([](const RunPoint& at) { return at.timeS; }), _metM);
        _hasBank = _hasBank && point.sample.rollRad && from.sample.rollRad && to.sample.rollRad;
        if (!_hasBank) return;
        const double turn = foundation::wrappedRad(*to.sample.rollRad - *from.sample.rollRad);
        const double bank = *from.sample.rollRad + foot.share * turn;
        _bank.add(foundation::degreesOf(foundation::wrappedRad(*point.sample.rollRad - bank)), _metM);
    }

    const std::vector<RunPoint>& _way;
    PlaceDifference _found;
    PlaceSum _beside, _height, _speed, _time, _bank;
    bool _hasBank = true, _hasMet = false;
    double _metM = 0.0, _lastM = 0.0;
    double _leastM = std::numeric_limits<double>::infinity(), _mostM = 0.0;
};

} // namespace

std::vector<PlaceDifference> comparePlaces(const MotionTable& table, const MotionTable& reference)
{
    std::vector<PlaceDifference> differences;
    for (const MotionTrack& expected : reference.tracks)
    {
        const MotionTrack* const track = table.find(expected.entity);
        const std::vector<RunPoint> way = runWay(reference, expected);
        if (!track || way.size() < 2 || way.back().alongM < kShortestRunM) continue;
        AlongRun along(way);
        for (const RunPoint& point : runWay(table, *track))
            along.add(point);
        differences.push_back(along.result(expected.entity));
    }
    return differences;
}

} // namespace simulation
