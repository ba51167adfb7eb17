// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/way/LeadOnWay.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <foundation/Angle.h>
#include <foundation/NearestOnSegment.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "simulation/player/EntityBox.h"

namespace simulation
{
namespace
{

constexpr double kStripSideM = 0.3;     ///< room that a vehicle keeps to each side
constexpr double kStripStoreyM = 3.5;   ///< what is so far above or below is on another road
constexpr std::size_t kStripCoarse = 2; ///< points from one look to the next
constexpr std::size_t kPointsOfBox = 8; ///< of the way, to each side of a body's middle

/// The strip that a vehicle needs, and how far it looks.
class WayStrip
{
public:
    WayStrip(const DrivenWay& way, const BoundingBox& box, double frontM, double aheadM)
        : _points(way.points()), _halfM(0.5 * box.widthM), _frontM(frontM)
    {
        _first = way.at();
        _last = _first;
        _least = _most = glm::dvec2(_points[_first].place);
        while (_last + 1 < _points.size() && _points[_last].alongM < frontM + aheadM)
        {
            ++_last;
            _least = glm::min(_least, glm::dvec2(_points[_last].place));
            _most = glm::max(_most, glm::dvec2(_points[_last].place));
        }
    }

    /// Whether a body may reach into the strip at all, in little time.
    bool mayReach(const EntityState& state, const BoundingBox& box) const
    {
        const double reachM = box.lengthM + box.widthM + std::fabs(box.centre.x) + _halfM + kStripSideM;
        return state.position.x > _least.x - reachM && state.position.x < _most.x + reachM &&
               state.position.y > _least.y - reachM && state.position.y < _most.y + reachM;
    }

    /// The part of a body that reaches into the strip first; nothing: none does.
    std::optional<LeadOnWay> reach(const EntityState& state, const BoundingBox& box, bool keepsRules) const
    {
        const double heading = foundation::radiansOf(state.headingDeg);
        const glm::dvec2 along(std::cos(heading), std::sin(heading)), left(-along.y, along.x);
        const glm::dvec2 middle = glm::dvec2(state.position) + along * box.centre.x + left * box.centre.y;
        const double reachM = 0.5 * std::hypot(box.lengthM, box.widthM) + _halfM + kStripSideM;
        const auto nearest = nearestPoint(middle, reachM + 2.0 * kStripCoarse);
        if (!nearest) return std::nullopt;
        const double facing = std::cos(heading - _points[*nearest].headingRad);
        if (keepsRules && facing < -0.3) return std::nullopt;
        const double roomM = _halfM + (facing < -0.3 ? 0.0 : kStripSideM);
        const std::size_t from = std::max(_first, *nearest - std::min(*nearest, kPointsOfBox));
        const std::size_t to = std::min(_last, *nearest + kPointsOfBox);
        double rearM = 1e300;
        const int parts = std::max(2, static_cast<int>(std::ceil(box.lengthM / 1.5)));
        for (int i = 0; i <= parts; ++i)
            for (const double side : {-0.5, 0.0, 0.5})
            {
                const glm::dvec2 part = middle +
                                        along * (box.lengthM * (static_cast<double>(i) / parts - 0.5)) +
                                        left * (side * box.widthM);
                if (const auto atM = alongAt(part, from, to, roomM)) rearM = std::min(rearM, *atM);
            }
        if (rearM > 1e299) return std::nullopt;
        LeadOnWay lead;
        lead.rearM = rearM;
        lead.gapM = rearM - _frontM;
        lead.speedMps = state.speedMps * facing;
        return lead;
    }

private:
    std::optional<std::size_t> nearestPoint(const glm::dvec2& place, double withinM) const
    {
        std::size_t nearest = _first;
        double least = withinM * withinM;
        bool isFound = false;
        for (std::size_t i = _first; i <= _last; i += kStripCoarse)
        {
            const glm::dvec2 apart = place - glm::dvec2(_points[i].place);
            const double square = glm::dot(apart, apart);
            if (square >= least) continue;
            least = square;
            nearest = i;
            isFound = true;
        }
        return isFound ? std::optional(nearest) : std::nullopt;
    }

    /// Where a point lies along the way; nothing: beside the strip, or not ahead of the vehicle.
    std::optional<double> alongAt(const glm::dvec2& place, std::size_t from, std::size_t to,
                                  double roomM) const
    {
        constexpr double kUnderM = 0.5, kRoundingM = 1e-6;
        double least = roomM, atM = -1e300;
        for (std::size_t i = from; i < to; ++i)
        {
            const glm::dvec2 a(_points[i].place), b(_points[i + 1].place);
            // No part of a piece is nearer than its begin less its length; this spares most of the work.
            const double reachM = least + _points[i + 1].alongM - _points[i].alongM + kRoundingM;
            if (glm::dot(place - a, place - a) > reachM * reachM) continue;
            const double share = foundation::nearestShare(place, a, b);
            const double apart = glm::distance(place, a + share * (b - a));
            if (apart >= least) continue;
            least = apart;
            atM = _points[i].alongM + share * (_points[i + 1].alongM - _points[i].alongM);
        }
        return atM > _frontM - kUnderM ? std::optional(atM) : std::nullopt;
    }

    const std::vector<DrivenWay::Point>& _points;
    double _halfM, _frontM;
    std::size_t _first = 0, _last = 0;
    glm::dvec2 _least{0.0}, _most{0.0}; ///< corners around its points
};

} // namespace

std::vector<LeadOnWay> leadsOnWay(ActionScene& scene, int actor, const DrivenWay& way,
                                  const JunctionKeeper& keeper, double aheadM)
{
    const BoundingBox& own = boxOf(scene, actor);
    const WayStrip strip(way, own, way.alongM() + own.centre.x + 0.5 * own.lengthM, aheadM);
    std::vector<LeadOnWay> leads;
    const int count = static_cast<int>(scene.scenario().entities.size());
    for (int i = 0; i < count; ++i)
    {
        if (i == actor || !scene.isPresent(i)) continue;
        const EntityState& other = scene.motion(i).state();
        const BoundingBox& box = boxOf(scene, i);
        if (!strip.mayReach(other, box)) continue;
        auto found = strip.reach(other, box, keeper.isKept(i));
        if (!found) continue;
        // The height of the way there, not here.
        const auto& points = way.points();
        const auto at = std::lower_bound(points.begin(), points.end(), found->rearM,
                                         [](const DrivenWay::Point& point, double alongM)
                                         { return point.alongM < alongM; });
        if (at != points.end() && std::fabs(at->place.z - other.position.z) > kStripStoreyM) continue;
        found->entity = i;
        found->lengthM = box.lengthM;
        leads.push_back(*found);
    }
    std::stable_sort(leads.begin(), leads.end(),
                     [](const LeadOnWay& a, const LeadOnWay& b) { return a.rearM < b.rearM; });
    return leads;
}

} // namespace simulation
