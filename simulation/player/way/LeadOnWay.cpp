// SPDX-License-Identifier: Apache-2.0
// Source of the steps along a way, each as long as nothing can be met before: Hart, "Sphere tracing", The
// Visual Computer 12, 1996.
#include "simulation/player/way/LeadOnWay.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <foundation/Angle.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "simulation/player/EntityBox.h"
#include "simulation/road/BodyBox.h"

namespace simulation
{
namespace
{

/// Room that a vehicle keeps to each side of those who keep no rules, and of those who do: they were let in
/// where they are, and whoever comes towards it has its own lane.
constexpr double kStrangerSideM = 0.3, kOtherSideM = 0.1, kOncomingSideM = 0.0;
constexpr double kSweptStoreyM = 3.5; ///< what is so far above or below is on another road

BodyBox bodyOf(const glm::dvec2& place, const glm::dvec2& along, const BoundingBox& box)
{
    const glm::dvec2 left(-along.y, along.x);
    return {place + box.centre.x * along + box.centre.y * left, along, 0.5 * box.lengthM, 0.5 * box.widthM};
}

glm::dvec2 directionOf(double headingRad)
{
    return {std::cos(headingRad), std::sin(headingRad)};
}

/// The places that the body of a vehicle takes one after the other on its way, as far as it looks.
class SweptWay
{
public:
    SweptWay(const DrivenWay& way, const EntityState& state, const BoundingBox& box, double aheadM)
        : _points(way.points()),
          _box(box),
          _now(bodyOf(glm::dvec2(state.position), directionOf(foundation::radiansOf(state.headingDeg)), box)),
          _heightM(state.position.z),
          _alongM(way.alongM()),
          _frontM(_alongM + box.centre.x + 0.5 * box.lengthM),
          _halfDiagonalM(0.5 * std::hypot(box.lengthM, box.widthM))
    {
        _first = way.at();
        while (_first + 1 < _points.size() && _points[_first].alongM <= _alongM)
            ++_first;
        _last = _first;
        _least = _most = _now.middle;
        for (; _last < _points.size() && _points[_last].alongM < _alongM + aheadM; ++_last)
        {
            _least = glm::min(_least, glm::dvec2(_points[_last].place));
            _most = glm::max(_most, glm::dvec2(_points[_last].place));
        }
    }

    /// Whether a body may be on the way at all, in little time.
    bool mayReach(const EntityState& state, const BoundingBox& box) const
    {
        const double reachM =
            box.lengthM + box.widthM + std::fabs(box.centre.x) + _box.lengthM + std::fabs(_box.centre.x);
        return state.position.x > _least.x - reachM && state.position.x < _most.x + reachM &&
               state.position.y > _least.y - reachM && state.position.y < _most.y + reachM;
    }

    /// A body that the vehicle would meet; nothing: it passes it.
    std::optional<LeadOnWay> meet(const EntityState& state, const BoundingBox& box, bool keepsRules) const
    {
        const BodyBox other =
            bodyOf(glm::dvec2(state.position), directionOf(foundation::radiansOf(state.headingDeg)), box);
        const bool comes = glm::dot(other.along, _now.along) < -0.3;
        double roomM = !keepsRules ? kStrangerSideM : comes ? kOncomingSideM : kOtherSideM;
        if (std::fabs(state.position.z - _heightM) < kSweptStoreyM && areMeeting(_now, other, roomM))
        {
            // One beside it is passed close by; one that it touches stands before it or behind it.
            if (areMeeting(_now, other))
                return glm::dot(other.middle - _now.middle, _now.along) > 0.0
                           ? std::optional(leadAt(_alongM, state, _now.along, other))
                           : std::nullopt;
            roomM = 0.0;
        }
        const double reachM =
            _halfDiagonalM + other.halfLengthM + other.halfWidthM + 2.0 * roomM; // more than the diagonal
        for (std::size_t i = _first; i < _last;)
        {
            const BodyBox own = bodyOf(glm::dvec2(_points[i].place), _points[i].along, _box);
            const double apartM = glm::distance(own.middle, other.middle);
            if (apartM > reachM)
            {
                constexpr double kLongestStepM = 3.5; // of the middle from point to point, in a tight bend
                i += std::max<std::size_t>(1, static_cast<std::size_t>((apartM - reachM) / kLongestStepM));
                continue;
            }
            if (std::fabs(_points[i].place.z - state.position.z) < kSweptStoreyM &&
                areMeeting(own, other, roomM))
                return leadAt(firstMeetingM(i, other, roomM), state, own.along, other);
            ++i;
        }
        return std::nullopt;
    }

private:
    LeadOnWay leadAt(double alongM, const EntityState& state, const glm::dvec2& along,
                     const BodyBox& other) const
    {
        LeadOnWay lead;
        lead.gapM = alongM - _alongM;
        lead.rearM = _frontM + lead.gapM;
        lead.speedMps = state.speedMps * glm::dot(along, other.along);
        lead.lengthM = 2.0 * other.halfLengthM;
        lead.isAlong = glm::dot(along, other.along) > 0.5;
        return lead;
    }

    /// Where on the way to a point at which bodies meet they do so first.
    double firstMeetingM(std::size_t point, const BodyBox& other, double roomM) const
    {
        constexpr int kHalvings = 7;
        const DrivenWay::Point& to = _points[point];
        const bool isFirst = point == _first;
        const glm::dvec2 fromPlace =
            isFirst ? _now.middle - _box.centre.x * _now.along : glm::dvec2(_points[point - 1].place);
        const double fromM = isFirst ? _alongM : _points[point - 1].alongM;
        const double fromRad =
            isFirst ? std::atan2(_now.along.y, _now.along.x) : _points[point - 1].headingRad;
        const double turn = foundation::wrappedRad(to.headingRad - fromRad);
        double free = 0.0, met = 1.0;
        for (int i = 0; i < kHalvings; ++i)
        {
            const double share = 0.5 * (free + met);
            const BodyBox own = bodyOf(glm::mix(fromPlace, glm::dvec2(to.place), share),
                                       directionOf(fromRad + share * turn), _box);
            (areMeeting(own, other, roomM) ? met : free) = share;
        }
        return fromM + free * (to.alongM - fromM) + roomM;
    }

    const std::vector<DrivenWay::Point>& _points;
    const BoundingBox& _box;
    BodyBox _now;
    double _heightM, _alongM, _frontM, _halfDiagonalM;
    std::size_t _first = 0, _last = 0;
    glm::dvec2 _least{0.0}, _most{0.0}; ///< corners around its points
};

} // namespace

std::vector<LeadOnWay> leadsOnWay(ActionScene& scene, int actor, const DrivenWay& way,
                                  const JunctionKeeper& keeper, double aheadM)
{
    const SweptWay swept(way, scene.motion(actor).state(), boxOf(scene, actor), aheadM);
    std::vector<LeadOnWay> leads;
    const int count = static_cast<int>(scene.scenario().entities.size());
    for (int i = 0; i < count; ++i)
    {
        if (i == actor || !scene.isPresent(i)) continue;
        const EntityState& other = scene.motion(i).state();
        const BoundingBox& box = boxOf(scene, i);
        if (!swept.mayReach(other, box)) continue;
        auto found = swept.meet(other, box, keeper.isKept(i));
        if (!found) continue;
        found->entity = i;
        leads.push_back(*found);
    }
    std::stable_sort(leads.begin(), leads.end(),
                     [](const LeadOnWay& a, const LeadOnWay& b) { return a.rearM < b.rearM; });
    return leads;
}

} // namespace simulation
