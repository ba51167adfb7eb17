// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/GroundProfiles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/common.hpp>

#include "scenery/roads/HeightFit.h"

namespace scenery
{

namespace
{

using osgRoads::core::PlanPoint;
using osgRoads::core::Road;

constexpr double kPlaneMarginM = 10.0; ///< beyond the roads of an area, that one point has a plane too
constexpr int kPlaneSamples = 9;       ///< along a side of its box
constexpr double kInsideStepM = 5.0;
constexpr int kGradeSamples = 4;        ///< within a step, less one
constexpr std::size_t kFewestSteps = 8; ///< of a chain

/// A place along a chain.
struct ChainPlace
{
    const Road* road = nullptr;
    double s = 0.0;
    bool isReversed = false;

    PlanPoint point() const { return road->referenceLine.at(s); }
    /// The way that the chain goes there.
    glm::dvec2 way() const { return (isReversed ? -1.0 : 1.0) * point().tangent(); }
};

ChainPlace placeOn(const osgRoads::core::RoadNetwork& network, const RoadChain& chain, double alongM)
{
    std::size_t i = chain.links.size() - 1;
    while (i > 0 && chain.links[i].startM > alongM)
        --i;
    const RoadChain::Link& link = chain.links[i];
    const Road& road = network.roads[static_cast<std::size_t>(link.road)];
    const double onM = std::clamp(alongM - link.startM, 0.0, road.length);
    return {&road, link.isReversed ? road.length - onM : onM, link.isReversed};
}

} // namespace

struct GroundProfiles::Draft
{
    double stepM = 0.0;
    std::size_t reach = 0;                   ///< steps to each side over which heights are averaged
    std::size_t runIn = 0;                   ///< steps that are in the plane at an end
    std::vector<double> heightsM;            ///< at 0, stepM, …, the chain's length
    std::vector<double> leastM, mostM;       ///< rises from each to the next
    double startM = 0.0, endM = 0.0;         ///< of the ends above their planes' middles
    double startGrade = 0.0, endGrade = 0.0; ///< of the planes, along the chain
};

GroundProfiles::GroundProfiles(std::shared_ptr<const osgRoads::core::RoadNetwork> network, BaseSurface ground,
                               const GroundProfileLimits& limits)
    : _network(std::move(network)), _ground(std::move(ground)), _sources(_network->roads.size())
{
    const RoadChains parts = chainsOf(*_network);
    for (const MeetingArea& area : parts.areas)
        _planes.push_back(planeOf(area, limits.junctionSlope));
    std::vector<Draft> drafts;
    for (const RoadChain& chain : parts.chains)
        drafts.push_back(draftOf(chain, limits));
    fit(parts.chains, drafts);
    for (std::size_t i = 0; i < parts.chains.size(); ++i)
        _profiles.push_back(profileOf(parts.chains[i], std::move(drafts[i])));
    index(parts);
}

/// The plane nearest to the ground around an area, made gentler where it is too steep.
GroundProfiles::Plane GroundProfiles::planeOf(const MeetingArea& area, double steepest) const
{
    glm::dvec2 low(1e300), high(-1e300);
    const auto take = [&](const Road& road, double s)
    {
        const glm::dvec2 place = road.referenceLine.at(s).position;
        low = glm::min(low, place - kPlaneMarginM);
        high = glm::max(high, place + kPlaneMarginM);
    };
    for (const int inside : area.inside)
        for (double s = 0.0; s <= road(inside).length; s += kInsideStepM)
            take(road(inside), s);
    for (const MeetingArea::End& arm : area.arms)
        take(road(arm.road), arm.isEnd ? road(arm.road).length : 0.0);

    Plane plane{.middle = 0.5 * (low + high)};
    glm::dvec2 products(0.0), squares(0.0);
    for (int row = 0; row < kPlaneSamples; ++row)
        for (int column = 0; column < kPlaneSamples; ++column)
        {
            const glm::dvec2 share = glm::dvec2(column, row) / (kPlaneSamples - 1.0) - 0.5;
            const glm::dvec2 from = share * (high - low);
            const double heightM = _ground.heightM(plane.middle + from);
            plane.heightM += heightM / (kPlaneSamples * kPlaneSamples);
            products += heightM * from;
            squares += from * from;
        }
    plane.gradient = products / squares;
    const double slope = glm::length(plane.gradient);
    if (slope > steepest) plane.gradient *= steepest / slope;
    return plane;
}

/// The least and the greatest grade of the file's own heights within a step.
osgRoads::core::ValueRange GroundProfiles::ownGrades(const RoadChain& chain, double fromM, double stepM) const
{
    osgRoads::core::ValueRange grades;
    for (int i = 0; i <= kGradeSamples; ++i)
    {
        const ChainPlace place = placeOn(*_network, chain, fromM + stepM * i / kGradeSamples);
        grades.include((place.isReversed ? -1.0 : 1.0) * place.road->elevation.slope(place.s));
    }
    return grades;
}

/// What the file's own grades leave of the limit, wherever they are averaged with a step.
void GroundProfiles::limitRises(Draft& draft, const std::vector<osgRoads::core::ValueRange>& own,
                                double grade)
{
    const std::size_t reach = draft.reach + 2; // a spline's neighbours too
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        osgRoads::core::ValueRange near;
        for (std::size_t k = i - std::min(i, reach); k <= std::min(i + reach, own.size() - 1); ++k)
        {
            near.include(own[k].least);
            near.include(own[k].greatest);
        }
        const double most = std::max({grade, near.greatest, -near.least});
        draft.leastM.push_back((-most - near.least) * draft.stepM);
        draft.mostM.push_back((most - near.greatest) * draft.stepM);
    }
}

GroundProfiles::Draft GroundProfiles::draftOf(const RoadChain& chain, const GroundProfileLimits& limits) const
{
    Draft draft;
    const auto steps =
        std::max(kFewestSteps, static_cast<std::size_t>(std::ceil(chain.lengthM / limits.stepM)));
    draft.stepM = chain.lengthM / static_cast<double>(steps);
    const std::size_t parts = chain.startArea >= 0 && chain.endArea >= 0 ? 4 : 2;
    draft.reach =
        std::min(steps / parts - 1, static_cast<std::size_t>(std::lround(limits.runInM / draft.stepM)));
    draft.runIn = draft.reach + 1; // one more, so that the profile ends with the plane's grade
    std::vector<osgRoads::core::ValueRange> own;
    for (std::size_t i = 0; i <= steps; ++i)
    {
        const double alongM = static_cast<double>(i) * draft.stepM;
        draft.heightsM.push_back(_ground.heightM(placeOn(*_network, chain, alongM).point().position));
        if (i < steps) own.push_back(ownGrades(chain, alongM, draft.stepM));
    }
    limitRises(draft, own, limits.grade);
    const auto meet = [&](int area, double alongM, double& aboveM, double& grade)
    {
        if (area < 0) return;
        const Plane& plane = _planes[static_cast<std::size_t>(area)];
        const ChainPlace place = placeOn(*_network, chain, alongM);
        aboveM = plane.at(place.point().position) - plane.heightM;
        grade = glm::dot(plane.gradient, place.way());
    };
    meet(chain.startArea, 0.0, draft.startM, draft.startGrade);
    meet(chain.endArea, chain.lengthM, draft.endM, draft.endGrade);
    return draft;
}

/// Fits the middles of the planes, and what lies between the run-ins of chains.
void GroundProfiles::fit(const std::vector<RoadChain>& chains, std::vector<Draft>& drafts)
{
    std::vector<double> wishesM;
    for (const Plane& plane : _planes)
        wishesM.push_back(plane.heightM);
    std::vector<HeightStep> steps;
    std::vector<std::size_t> firsts;
    for (std::size_t c = 0; c < chains.size(); ++c)
    {
        const Draft& draft = drafts[c];
        const std::size_t last = draft.heightsM.size() - 1;
        firsts.push_back(wishesM.size());
        wishesM.insert(wishesM.end(), draft.heightsM.begin(), draft.heightsM.end());
        const auto runInM = [&](double grade)
        { return grade * draft.stepM * static_cast<double>(draft.runIn); };
        // The node of a place along the chain, and how far the place is above it.
        const auto node = [&](std::size_t i) -> std::pair<std::size_t, double>
        {
            if (i <= draft.runIn && chains[c].startArea >= 0)
                return {static_cast<std::size_t>(chains[c].startArea),
                        draft.startM + runInM(draft.startGrade)};
            if (i + draft.runIn >= last && chains[c].endArea >= 0)
                return {static_cast<std::size_t>(chains[c].endArea), draft.endM - runInM(draft.endGrade)};
            return {firsts.back() + i, 0.0};
        };
        for (std::size_t i = 0; i < last; ++i)
        {
            const auto [from, fromM] = node(i);
            const auto [to, toM] = node(i + 1);
            const bool isRigid = from == to;
            if (!isRigid)
                steps.push_back({from, to, draft.leastM[i] + fromM - toM, draft.mostM[i] + fromM - toM});
        }
    }
    const std::vector<double> heightsM = fitHeights(wishesM, steps);
    for (std::size_t i = 0; i < _planes.size(); ++i)
        _planes[i].heightM = heightsM[i];
    for (std::size_t c = 0; c < chains.size(); ++c)
        std::copy_n(heightsM.begin() + static_cast<std::ptrdiff_t>(firsts[c]), drafts[c].heightsM.size(),
                    drafts[c].heightsM.begin());
}

/// Averages the heights of a chain. Beyond an area the plane goes on, beyond an end in the open the mirrored
/// profile.
GroundProfiles::Profile GroundProfiles::profileOf(const RoadChain& chain, Draft draft) const
{
    const auto last = static_cast<std::ptrdiff_t>(draft.heightsM.size()) - 1;
    const auto reach = static_cast<std::ptrdiff_t>(draft.reach);
    const auto startPlaneM = [&](std::ptrdiff_t i)
    {
        return _planes[static_cast<std::size_t>(chain.startArea)].heightM + draft.startM +
               static_cast<double>(i) * draft.stepM * draft.startGrade;
    };
    const auto endPlaneM = [&](std::ptrdiff_t i)
    {
        return _planes[static_cast<std::size_t>(chain.endArea)].heightM + draft.endM +
               static_cast<double>(i - last) * draft.stepM * draft.endGrade;
    };
    const auto at = [&](std::ptrdiff_t i) -> double& { return draft.heightsM[static_cast<std::size_t>(i)]; };
    for (std::ptrdiff_t i = 0; i <= reach + 1; ++i)
    {
        if (chain.startArea >= 0) at(i) = startPlaneM(i);
        if (chain.endArea >= 0) at(last - i) = endPlaneM(last - i);
    }
    const auto heightAt = [&](std::ptrdiff_t i)
    {
        if (i < 0) return chain.startArea >= 0 ? startPlaneM(i) : 2.0 * at(0) - at(-i);
        if (i > last) return chain.endArea >= 0 ? endPlaneM(i) : 2.0 * at(last) - at(2 * last - i);
        return at(i);
    };
    Profile profile{
        {draft.stepM, {}}, draft.stepM * static_cast<double>(reach), chain.startArea, chain.endArea};
    for (std::ptrdiff_t i = -1; i <= last + 1; ++i)
    {
        double sum = 0.0;
        for (std::ptrdiff_t k = i - reach; k <= i + reach; ++k)
            sum += heightAt(k);
        profile.spline.heightsM.push_back(sum / static_cast<double>(2 * reach + 1));
    }
    return profile;
}

void GroundProfiles::index(const RoadChains& parts)
{
    for (std::size_t i = 0; i < parts.areas.size(); ++i)
        for (const int inside : parts.areas[i].inside)
            _sources[static_cast<std::size_t>(inside)].plane = static_cast<int>(i);
    for (std::size_t i = 0; i < parts.chains.size(); ++i)
        for (const RoadChain::Link& link : parts.chains[i].links)
            _sources[static_cast<std::size_t>(link.road)] = {-1, static_cast<int>(i), link.startM,
                                                             link.isReversed};
}

double GroundProfiles::heightM(const osgRoads::core::RoadPosition& position, const glm::dvec2& plan) const
{
    const Source& source = _sources[static_cast<std::size_t>(position.road)];
    if (source.plane >= 0) return _planes[static_cast<std::size_t>(source.plane)].at(plan);
    if (source.profile < 0) return _ground.heightM(plan);
    const Road& on = road(position.road);
    const Profile& profile = _profiles[static_cast<std::size_t>(source.profile)];
    const double alongM = source.startM + (source.isReversed ? on.length - position.s : position.s);
    double heightM = profile.spline.heightM(alongM);
    const auto lean = [&](int plane, double fromEndM)
    {
        if (plane < 0 || fromEndM >= profile.runInM) return;
        const glm::dvec2 aside = plan - on.referenceLine.at(position.s).position;
        heightM += glm::smoothstep(0.0, 1.0, 1.0 - fromEndM / profile.runInM) *
                   glm::dot(_planes[static_cast<std::size_t>(plane)].gradient, aside);
    };
    lean(profile.startPlane, alongM);
    lean(profile.endPlane, profile.spline.lengthM() - alongM);
    return heightM;
}

} // namespace scenery
