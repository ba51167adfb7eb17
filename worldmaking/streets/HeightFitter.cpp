// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/HeightFitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scenery/roads/HeightFit.h"
#include "worldmaking/streets/HeightRoom.h"

namespace worldmaking
{

namespace
{

using scenery::HeightStep;

constexpr double kLeastRiseM = 1.5;                       ///< of an overpass: with less it is given up
constexpr double kLeastLevelM = 0.25, kMostLevelM = 0.55; ///< of a street above the formation of a track

/// The gradient of the plane that fits the beginnings of the arms best.
glm::dvec2 gradientOf(const HeightNodes& nodes, std::size_t area, const std::vector<double>& heights)
{
    double xx = 1.0, xy = 0.0, yy = 1.0; // square metres; level where arms are too short to tell
    glm::dvec2 right(0.0);
    for (const StreetArm& arm : nodes.areas[area].arms)
    {
        const HeightRow& row = nodes.rows[arm.chain];
        const std::size_t node = arm.isEnd ? row.last() - 1 : 1;
        const glm::dvec2 way = row.points[node].position - nodes.areas[area].middle;
        xx += way.x * way.x, xy += way.x * way.y, yy += way.y * way.y;
        right += (heights[row.first + node] - heights[area]) * way;
    }
    const double determinant = xx * yy - xy * xy;
    const glm::dvec2 gradient((yy * right.x - xy * right.y) / determinant,
                              (xx * right.y - xy * right.x) / determinant);
    const double slope = glm::length(gradient);
    return slope > kMostLean ? gradient * (kMostLean / slope) : gradient;
}

std::vector<CrossingPlane> planesOf(const HeightNodes& nodes, const std::vector<double>& heights)
{
    std::vector<CrossingPlane> planes;
    for (std::size_t i = 0; i < nodes.areas.size(); ++i)
        planes.push_back({nodes.areas[i].middle, gradientOf(nodes, i, heights), heights[i]});
    return planes;
}

/// Collects how far heights may differ.
class StepMaker
{
public:
    StepMaker(const HeightNodes& nodes, const std::vector<CrossingPlane>& planes)
        : _nodes(nodes), _planes(planes)
    {
    }

    void addRow(const HeightRow& row, const StreetChain& chain)
    {
        if (const auto area = _nodes.areaAt(chain.startCrossing)) tie(*area, row, false);
        for (std::size_t k = 0; k < row.last(); ++k)
        {
            const double mostM = std::min(row.steepest[k], row.steepest[k + 1]) * row.stepM;
            steps.push_back({row.first + k, row.first + k + 1, -mostM, mostM});
        }
        if (const auto area = _nodes.areaAt(chain.endCrossing)) tie(*area, row, true);
    }

    void addOverpass(const OverpassNodes& pass)
    {
        for (const std::size_t below : pass.lower)
            for (const std::size_t above : pass.upper)
                steps.push_back({below, above, pass.riseM, std::numeric_limits<double>::infinity()});
    }

    void addLevel(const LevelNodes& level)
    {
        steps.push_back({level.track, level.street, kLeastLevelM, kMostLevelM});
    }

    std::vector<HeightStep> steps;

private:
    /// Holds the mouth of a road, and the nodes after it that lie in the plane of an area.
    void tie(std::size_t area, const HeightRow& row, bool isEnd)
    {
        const CrossingPlane& plane = _planes[area];
        for (std::size_t i = 0; i <= (isEnd ? row.heldEnd : row.heldStart); ++i)
        {
            const std::size_t node = isEnd ? row.last() - i : i;
            const double rise = glm::dot(plane.gradient, row.points[node].position - plane.middle);
            steps.push_back({area, row.first + node, rise, rise});
        }
    }

    const HeightNodes& _nodes;
    const std::vector<CrossingPlane>& _planes;
};

/// Fits, and gives way where limits contradict each other.
class HeightFitter
{
public:
    HeightFitter(const StreetGraph& graph, const HeightNodes& nodes, const std::vector<double>& wishes,
                 const FitLimits& limits)
        : planes(planesOf(nodes, wishes)), _graph(graph), _nodes(nodes), _wishes(wishes), _limits(limits)
    {
    }

    std::vector<double> fit()
    {
        std::vector<double> heights = fitted({});
        for (int attempt = 0; attempt < kMostAttempts && levelStrained(heights); ++attempt)
            heights = fitted({});
        std::vector<OverpassNodes> overpasses = withRoom(HeightRoom(heights, _steps));
        while (!overpasses.empty())
        {
            heights = fitted(overpasses);
            const std::vector<char> strained = strainedNodes(heights);
            const auto isStrained = [&](const OverpassNodes& pass)
            {
                const bool isKept = pass.all([&](std::size_t below, std::size_t above)
                                             { return strained[below] == 0 && strained[above] == 0; });
                if (!isKept) lost.push_back(pass.number);
                return !isKept;
            };
            if (std::erase_if(overpasses, isStrained) == 0) break; // each has room, and all together
            if (overpasses.empty()) heights = fitted({});
        }
        std::sort(lost.begin(), lost.end());
        lost.erase(std::unique(lost.begin(), lost.end()), lost.end());
        return heights;
    }

    std::vector<CrossingPlane> planes;
    std::vector<std::size_t> lost;

private:
    static constexpr int kMostAttempts = 12;
    static constexpr double kErrorM = 0.001, kLessLean = 0.5, kLevel = 0.005;

    /// The overpasses with the rise that there is room for; those with too little are lost.
    std::vector<OverpassNodes> withRoom(const HeightRoom& room)
    {
        std::vector<OverpassNodes> kept;
        for (OverpassNodes pass : _limits.overpasses)
        {
            double mostM = pass.riseM;
            for (const std::size_t below : pass.lower)
                for (const std::size_t above : pass.upper)
                    mostM = std::min(mostM, room.mostM(below, above, pass.riseM));
            if (mostM < pass.riseM)
            {
                lost.push_back(pass.number);
                pass.riseM = mostM - kErrorM;
            }
            if (pass.riseM >= kLeastRiseM) kept.push_back(pass);
        }
        return kept;
    }

    std::vector<double> fitted(const std::vector<OverpassNodes>& overpasses)
    {
        StepMaker maker(_nodes, planes);
        for (std::size_t i = 0; i < _nodes.rows.size(); ++i)
            maker.addRow(_nodes.rows[i], _graph.chains[i]);
        for (const OverpassNodes& pass : overpasses)
            maker.addOverpass(pass);
        for (const LevelNodes& level : _limits.levels)
            maker.addLevel(level);
        _steps = std::move(maker.steps);
        if (_limits.bounds.empty()) return scenery::fitHeights(_wishes, _steps);
        return scenery::fitHeights(scenery::boundWishes(_wishes, _steps, _limits.bounds), _steps);
    }

    /// Returns for each node whether a step at it is not kept.
    std::vector<char> strainedNodes(const std::vector<double>& heights) const
    {
        std::vector<char> isStrained(_nodes.count, 0);
        for (const HeightStep& step : _steps)
        {
            const double rise = heights[step.to] - heights[step.from];
            if (rise < step.leastM - kErrorM || rise > step.mostM + kErrorM)
                isStrained[step.from] = isStrained[step.to] = 1;
        }
        return isStrained;
    }

    /// Makes planes more level around steps that are not kept. Returns false if there is none.
    bool levelStrained(const std::vector<double>& heights)
    {
        const std::vector<char> isStrained = strainedNodes(heights);
        bool isLevelled = false;
        for (std::size_t i = 0; i < planes.size(); ++i)
        {
            glm::dvec2& gradient = planes[i].gradient;
            if (gradient == glm::dvec2(0.0) || !isStrainedAround(i, isStrained)) continue;
            gradient *= glm::length(gradient) < kLevel ? 0.0 : kLessLean;
            isLevelled = true;
        }
        return isLevelled;
    }

    bool isStrainedAround(std::size_t area, const std::vector<char>& isStrained) const
    {
        const auto& arms = _nodes.areas[area].arms;
        return std::any_of(arms.begin(), arms.end(),
                           [&](const StreetArm& arm)
                           {
                               const HeightRow& row = _nodes.rows[arm.chain];
                               const std::size_t mouth = row.first + _nodes.mouth(arm);
                               const std::size_t held = arm.isEnd ? row.heldEnd : row.heldStart;
                               const auto first = isStrained.begin() + static_cast<std::ptrdiff_t>(
                                                                           arm.isEnd ? mouth - held : mouth);
                               return std::any_of(first, first + static_cast<std::ptrdiff_t>(held) + 1,
                                                  [](char node) { return node != 0; });
                           });
    }

    const StreetGraph& _graph;
    const HeightNodes& _nodes;
    const std::vector<double>& _wishes;
    const FitLimits& _limits;
    std::vector<HeightStep> _steps;
};

} // namespace

FittedHeights fitToLimits(const StreetGraph& graph, const HeightNodes& nodes,
                          const std::vector<double>& wishesM, const FitLimits& limits)
{
    HeightFitter fitter(graph, nodes, wishesM, limits);
    FittedHeights fitted;
    fitted.heightsM = fitter.fit();
    fitted.planes = std::move(fitter.planes);
    for (std::size_t i = 0; i < fitted.planes.size(); ++i)
        fitted.planes[i].heightM = fitted.heightsM[i];
    fitted.lost = std::move(fitter.lost);
    return fitted;
}

} // namespace worldmaking
