// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulation/contact/Obstacle.h"

namespace simulation
{

/// Things as they are gathered for a map, with names that many share.
class ObstacleList
{
public:
    /// Adds a thing; `name` tells more than its kind ("oak"), and may be empty. Things that are not finite,
    /// or have no size, are left out.
    void add(Obstacle obstacle, std::string_view name = {});

    /// Adds all of another list.
    void add(const ObstacleList& more);

    const std::vector<Obstacle>& obstacles() const { return _obstacles; }
    const std::vector<std::string>& names() const { return _names; }

private:
    std::vector<Obstacle> _obstacles;
    std::vector<std::string> _names{std::string()};
};

/// What stands in a scene, found by its place: a grid of cells over the plan, of which those that hold
/// something are kept in the order of their keys.
/// Cost: building O(n log n), a look-up a binary search for each cell of the rectangle. Memory: 96 B a thing
/// and 16 B for each cell that it touches. Threads: any may look up.
class ObstacleMap
{
public:
    ObstacleMap() = default;
    explicit ObstacleMap(ObstacleList list);

    /// The numbers of all things whose upright rectangle touches this one of the plan, ascending. `found` is
    /// cleared before.
    void near(const glm::dvec2& low, const glm::dvec2& high, std::vector<std::uint32_t>& found) const;

    const Obstacle& at(std::uint32_t number) const { return _list.obstacles()[number]; }
    /// The same things, each so far from its place.
    ObstacleList moved(const glm::dvec2& by) const;

    std::size_t size() const { return _list.obstacles().size(); }

    /// What a thing is, for people: "oak", or the name of its kind.
    std::string_view nameOf(std::uint32_t number) const;

    static constexpr double kCellM = 16.0;
    static constexpr double kLargestM = 4000.0; ///< half a side; larger things are cut to it

private:
    struct Entry
    {
        std::uint64_t cell;
        std::uint32_t number;
    };

    ObstacleList _list;
    std::vector<Entry> _entries; ///< by cell, then number
};

} // namespace simulation
