// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/CloseStreets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include <foundation/NearestOnSegment.h>
#include <glm/geometric.hpp>

namespace worldmaking
{

namespace
{

constexpr double kStepCellM = 40.0;  ///< more than two half widths, kCloseM and a step
constexpr double kMostWeight = 60.0; ///< where pavings touch
constexpr double kOwnAwayM = 40.0;   ///< along a street to where it is beside itself
constexpr double kPortalM =
    60.0; ///< from a bridge or tunnel on, whose slope goes on from that of the street before it

/// A step of a row: from one node to the next.
struct Step
{
    std::size_t row = 0, node = 0;
};

/// The steps of all rows by the cells of a grid.
class StepGrid
{
public:
    explicit StepGrid(const HeightNodes& nodes)
    {
        for (std::size_t row = 0; row < nodes.rows.size(); ++row)
            for (std::size_t k = 0; k < nodes.rows[row].last(); ++k)
                _cells[keyAt(nodes.rows[row].points[k].position, 0, 0)].push_back({row, k});
    }

    template<class Use>
    void around(const glm::dvec2& place, const Use& use) const
    {
        for (int north = -1; north <= 1; ++north)
            for (int east = -1; east <= 1; ++east)
                if (const auto found = _cells.find(keyAt(place, east, north)); found != _cells.end())
                    for (const Step& step : found->second)
                        use(step);
    }

private:
    static std::int64_t keyAt(const glm::dvec2& place, int east, int north)
    {
        const auto column = static_cast<std::int64_t>(std::floor(place.x / kStepCellM)) + east;
        const auto row = static_cast<std::int64_t>(std::floor(place.y / kStepCellM)) + north;
        return row * 0x100000000LL + column;
    }

    std::unordered_map<std::int64_t, std::vector<Step>> _cells;
};

/// Finds the ties of one node.
class TieFinder
{
public:
    TieFinder(const HeightNodes& nodes, const std::vector<double>& halfWidthsM)
        : _nodes(nodes), _halfM(halfWidthsM), _grid(nodes)
    {
    }

    /// Adds the nearest place of each row beside a node.
    void addTies(std::size_t row, std::size_t k, std::vector<StreetTie>& ties) const
    {
        const HeightRow& own = _nodes.rows[row];
        if (isAtPortal(own, k)) return;
        std::vector<std::pair<std::size_t, StreetTie>> best; // by row
        const auto look = [&](const Step& step)
        {
            const HeightRow& other = _nodes.rows[step.row];
            if (isAtPortal(other, step.node) || isAtPortal(other, step.node + 1)) return;
            const double alongM = (static_cast<double>(step.node) - static_cast<double>(k)) * own.stepM;
            if (step.row == row && std::abs(alongM) < kOwnAwayM) return;
            const auto tie = tieOf(own.points[k].position, step, _halfM[row]);
            if (tie.weight <= 0.0) return;
            const auto same =
                std::find_if(best.begin(), best.end(), [&](const auto& b) { return b.first == step.row; });
            if (same == best.end())
                best.emplace_back(step.row, tie);
            else if (tie.weight > same->second.weight)
                same->second = tie;
        };
        _grid.around(own.points[k].position, look);
        for (auto& [other, tie] : best)
        {
            tie.node = own.first + k;
            ties.push_back(tie);
        }
    }

private:
    /// Whether a node is on a bridge or in a tunnel, or near its end.
    static bool isAtPortal(const HeightRow& row, std::size_t k)
    {
        const auto reach = static_cast<std::size_t>(kPortalM / row.stepM);
        const std::size_t first = k > reach ? k - reach : 0, last = std::min(row.last(), k + reach);
        return std::any_of(row.isFree.begin() + static_cast<std::ptrdiff_t>(first),
                           row.isFree.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                           [](auto isFree) { return isFree != 0; });
    }

    StreetTie tieOf(const glm::dvec2& place, const Step& step, double halfM) const
    {
        const HeightRow& other = _nodes.rows[step.row];
        const glm::dvec2 from = other.points[step.node].position,
                         way = other.points[step.node + 1].position - from;
        const double share = foundation::nearestShare(place, from, other.points[step.node + 1].position);
        const double gapM = glm::distance(place, from + share * way) - halfM - _halfM[step.row];
        const double near = std::clamp(1.0 - gapM / kCloseM, 0.0, 1.0);
        return {0, other.first + step.node, other.first + step.node + 1, share,
                kMostWeight * near * near * near * near};
    }

    const HeightNodes& _nodes;
    const std::vector<double>& _halfM;
    StepGrid _grid;
};

} // namespace

std::vector<StreetTie> closeStreets(const HeightNodes& nodes, const std::vector<double>& halfWidthsM)
{
    const TieFinder finder(nodes, halfWidthsM);
    std::vector<StreetTie> ties;
    for (std::size_t row = 0; row < nodes.rows.size(); ++row)
        for (std::size_t k = 0; k <= nodes.rows[row].last(); ++k)
            finder.addTies(row, k, ties);
    return ties;
}

} // namespace worldmaking
