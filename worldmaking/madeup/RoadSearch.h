// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "worldmaking/madeup/GroundGrid.h"

namespace worldmaking
{

/// Finds the ways for new roads over a ground: those of least cost, by length, grade and what has to be
/// crossed, where roads that are there already are cheap. Frame: the plane. Units: metres, metres a metre.
/// Sources: Galin, Peytavie, Maréchal & Guérin, *Procedural generation of roads*, 2010, §4 (costs of grade
/// and water, directions beyond the eight neighbours; ours have no cost of curvature); Hart, Nilsson &
/// Raphael 1968 (A*), by Boost.Graph.
class RoadSearch
{
public:
    /// What a metre of road costs at a place beside the grade: 1 on free ground; nothing below 0.3; negative:
    /// no road at all.
    using Toll = std::function<double(const glm::dvec2& place)>;

    /// `cellM`: between places that roads can take.
    RoadSearch(const GroundGrid& ground, double cellM, const Toll& toll);
    ~RoadSearch();
    RoadSearch(const RoadSearch&) = delete;
    RoadSearch& operator=(const RoadSearch&) = delete;

    /// Returns the way from the place of the search that is nearest to one place to that nearest to another;
    /// empty where none leads.
    std::vector<glm::dvec2> path(const glm::dvec2& from, const glm::dvec2& to) const;

    /// Whether a way leads from a place to most of the ground: it lies in the largest part that ways hold
    /// together.
    bool isReachable(const glm::dvec2& place) const;

    /// Makes a way cheap for the next ones.
    void use(const std::vector<glm::dvec2>& path);
    /// Whether a place of the search lies on a way that use() was told of.
    bool isUsed(const glm::dvec2& place) const;

    static constexpr double kSteepest = 0.13; ///< no road climbs more between two places

private:
    struct Graph;
    std::unique_ptr<Graph> _graph;
};

} // namespace worldmaking
