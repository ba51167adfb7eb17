// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/PlanMap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace scenery
{

namespace
{

constexpr double kNodeM = 1000.0;   ///< between nodes, at most
constexpr double kUpM = 1000.0;     ///< height over which `up` is measured
constexpr double kAffineM = 1e-7;   ///< by which a map may depart from an affine one
constexpr int kMostSteps = 64;      ///< between nodes, along a side
constexpr int kMostIterations = 20; ///< of the inverse; three or four do

/// The weights of the nodes at -1, 0, 1 and 2.
std::array<double, 4> weights(double u)
{
    return {-u * (u - 1.0) * (u - 2.0) / 6.0, (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0,
            -(u + 1.0) * u * (u - 2.0) / 2.0, (u + 1.0) * u * (u - 1.0) / 6.0};
}

int stepsFor(double extentM)
{
    return static_cast<int>(std::clamp(std::ceil(extentM / kNodeM), 1.0, double{kMostSteps}));
}

} // namespace

foundation::Result<PlanMap> PlanMap::create(const glm::dvec2& low, const glm::dvec2& high, const Place& place)
{
    PlanMap map;
    const glm::dvec2 extentM = glm::max(high - low, glm::dvec2(1.0));
    const int across = stepsFor(extentM.x), up = stepsFor(extentM.y);
    map._low = low;
    map._middle = low + 0.5 * extentM;
    map._stepM = extentM / glm::dvec2(across, up);
    map._columns = across + 3;
    map._rows = up + 3;
    for (int row = -1; row < map._rows - 1; ++row)
        for (int column = -1; column < map._columns - 1; ++column)
        {
            const glm::dvec2 plan = low + glm::dvec2(column, row) * map._stepM;
            const auto ground = place(plan, 0.0);
            if (!ground) return ground.error();
            const auto above = place(plan, kUpM);
            if (!above) return above.error();
            map._nodes.push_back({*ground, (*above - *ground) / kUpM});
        }
    map._affine = map.affineMap();
    const Node middle = map.at(map._middle);
    const glm::dvec2 half = 0.5 * extentM;
    const auto slope = [&](const glm::dvec2& way)
    {
        return (map.at(map._middle + way).position - map.at(map._middle - way).position) /
               (2.0 * glm::length(way));
    };
    map._toPlan = glm::inverse(glm::dmat3(slope({half.x, 0.0}), slope({0.0, half.y}), middle.up));
    return map;
}

/// The map as an affine one, if every node is where that would have it.
std::optional<PlanMap::Affine> PlanMap::affineMap() const
{
    const auto node = [this](int column, int row) -> const Node&
    { return _nodes[static_cast<std::size_t>((row + 1) * _columns + column + 1)]; };
    Affine map{node(0, 0)};
    map.east = node(1, 0).position - map.origin.position;
    map.north = node(0, 1).position - map.origin.position;
    for (int row = -1; row < _rows - 1; ++row)
        for (int column = -1; column < _columns - 1; ++column)
        {
            const glm::dvec3 expected = map.origin.position + static_cast<double>(column) * map.east +
                                        static_cast<double>(row) * map.north;
            if (glm::distance(node(column, row).position, expected) > kAffineM) return std::nullopt;
            if (glm::distance(node(column, row).up, map.origin.up) > kAffineM / kUpM) return std::nullopt;
        }
    return map;
}

PlanMap::Node PlanMap::at(const glm::dvec2& plan) const
{
    const glm::dvec2 place = (plan - _low) / _stepM;
    if (_affine)
        return {_affine->origin.position + place.x * _affine->east + place.y * _affine->north,
                _affine->origin.up};
    const int column = static_cast<int>(std::clamp(std::floor(place.x), 0.0, _columns - 4.0));
    const int row = static_cast<int>(std::clamp(std::floor(place.y), 0.0, _rows - 4.0));
    const auto across = weights(place.x - column), along = weights(place.y - row);
    Node node{glm::dvec3(0.0), glm::dvec3(0.0)};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
        {
            const Node& corner = _nodes[static_cast<std::size_t>((row + j) * _columns + column + i)];
            const double weight = across[static_cast<std::size_t>(i)] * along[static_cast<std::size_t>(j)];
            node.position += weight * corner.position;
            node.up += weight * corner.up;
        }
    return node;
}

glm::dvec3 PlanMap::toScene(const glm::dvec3& plan) const
{
    const Node node = at(plan);
    return node.position + plan.z * node.up;
}

glm::dvec3 PlanMap::toPlan(const glm::dvec3& scene) const
{
    glm::dvec3 plan(_middle, 0.0);
    for (int i = 0; i < kMostIterations; ++i)
    {
        const glm::dvec3 step = _toPlan * (scene - toScene(plan));
        plan += step;
        if (std::abs(step.x) + std::abs(step.y) + std::abs(step.z) < 1e-8) break;
    }
    return plan;
}

} // namespace scenery
