// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/streets/Overpass.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

struct PlanPiece
{
    std::size_t chain = 0, piece = 0;
    glm::dvec2 from{0.0}, to{0.0};
};

/// The pieces of streets and railways, by a grid. Frame: the plan.
class PlanPieces
{
public:
    PlanPieces(const StreetGraph& graph, const std::vector<glm::dvec2>& places)
    {
        for (std::size_t chain = 0; chain < graph.chains.size(); ++chain)
            for (std::size_t piece = 0; piece < graph.chains[chain].pieces.size(); ++piece)
            {
                const auto& points = graph.chains[chain].points;
                const PlanPiece made{chain, piece, places[points[piece]], places[points[piece + 1]]};
                _grid.add(_pieces.size(), {glm::min(made.from, made.to), glm::max(made.from, made.to)});
                _pieces.push_back(made);
            }
    }

    /// Calls `use(piece)` for each whose box meets a box.
    template<class Use>
    void near(const MapBox& box, const Use& use) const
    {
        _grid.near(box, [&](std::size_t i) { use(_pieces[i]); });
    }

    /// Calls `use(piece, share of it, share of the line)` for each piece that a line crosses, but at points
    /// in common.
    template<class Use>
    void crossing(const glm::dvec2& from, const glm::dvec2& to, const Use& use) const
    {
        constexpr double kSamePlaceM = 0.05;
        const auto look = [&](const PlanPiece& piece)
        {
            const auto shares = crossingShares(piece.from, piece.to, from, to);
            if (!shares) return;
            const glm::dvec2 at = glm::mix(from, to, shares->y);
            const auto isAt = [&](const glm::dvec2& end) { return glm::distance(end, at) < kSamePlaceM; };
            if ((isAt(from) || isAt(to)) && (isAt(piece.from) || isAt(piece.to))) return;
            use(piece, *shares);
        };
        near({glm::min(from, to), glm::max(from, to)}, look);
    }

private:
    std::vector<PlanPiece> _pieces;
    PlanGrid _grid;
};

} // namespace worldmaking
