// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/Overpass.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace worldmaking
{

namespace
{

constexpr double kCellM = 100.0;

struct PieceRef
{
    std::size_t chain = 0, piece = 0;

    auto operator<=>(const PieceRef&) const = default;
};

/// Finds pairs of pieces that come near each other, each once.
class PieceGrid
{
public:
    PieceGrid(const StreetGraph& graph, const std::vector<glm::dvec2>& places)
    {
        for (std::size_t chain = 0; chain < graph.chains.size(); ++chain)
            for (std::size_t piece = 0; piece < graph.chains[chain].pieces.size(); ++piece)
            {
                const auto& points = graph.chains[chain].points;
                add({chain, piece}, places[points[piece]], places[points[piece + 1]]);
            }
    }

    std::set<std::pair<PieceRef, PieceRef>> pairs() const
    {
        std::set<std::pair<PieceRef, PieceRef>> found;
        for (const auto& [cell, pieces] : _cells)
            for (std::size_t i = 0; i < pieces.size(); ++i)
                for (std::size_t j = i + 1; j < pieces.size(); ++j)
                    found.insert(std::minmax(pieces[i], pieces[j]));
        return found;
    }

private:
    void add(const PieceRef& piece, glm::dvec2 a, glm::dvec2 b)
    {
        const glm::dvec2 low = glm::floor(glm::min(a, b) / kCellM),
                         high = glm::floor(glm::max(a, b) / kCellM);
        for (double x = low.x; x <= high.x; ++x)
            for (double y = low.y; y <= high.y; ++y)
                _cells[static_cast<long long>(x) * 0x40000000LL + static_cast<long long>(y)].push_back(piece);
    }

    std::unordered_map<long long, std::vector<PieceRef>> _cells;
};

/// Crossings that have been found: one at a node of a line is that of both of its pieces.
class KnownPlaces
{
public:
    bool isNew(const Overpass& pass)
    {
        constexpr double kSameM = 0.05;
        auto& placesM = _placesM[{pass.upper, pass.lower}];
        for (const glm::dvec2& known : placesM)
            if (std::fabs(known.x - pass.upperM) < kSameM && std::fabs(known.y - pass.lowerM) < kSameM)
                return false;
        placesM.emplace_back(pass.upperM, pass.lowerM);
        return true;
    }

private:
    std::map<std::pair<std::size_t, std::size_t>, std::vector<glm::dvec2>> _placesM;
};

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

} // namespace

std::optional<glm::dvec2> crossingShares(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d)
{
    const double area = cross(b - a, d - c);
    if (std::fabs(area) < 1e-9) return std::nullopt;
    const double u = cross(c - a, d - c) / area, v = cross(c - a, b - a) / area;
    if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) return std::nullopt;
    return glm::dvec2(u, v);
}

double sineBetween(glm::dvec2 a, glm::dvec2 b)
{
    return std::fabs(cross(a, b)) / (glm::length(a) * glm::length(b));
}

Separation separationOf(const StreetTraits& upper, const StreetTraits& lower)
{
    constexpr double kWireM = 5.9; // of the contact wire above the formation
    const double deckM = upper.isTrack ? kTrackDeckM : kRoadDeckM;
    if (!lower.isTrack && lower.place == StreetPlace::tunnel)
        return {kTunnelRoofM + (upper.place == StreetPlace::tunnel ? kRoundingM : 0.0), kClearM};
    if (!lower.isTrack) return {kClearM + deckM + kRoundingM, kClearM};
    const double topM = lower.hasWire ? kWireM + 0.3 : kRailTopM + kClearM;
    return {topM + deckM + kRoundingM, kClearM};
}

Overpasses overpassesOf(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                        const std::vector<CentreLine>& lines)
{
    Overpasses result;
    KnownPlaces known;
    const auto traits = [&](const PieceRef& ref) -> const StreetTraits&
    { return graph.traitsAt(graph.chains[ref.chain], ref.piece); };
    const auto along = [&](const PieceRef& ref, double share)
    {
        const auto& pointsM = lines[ref.chain].pointsM();
        return pointsM[ref.piece] + share * (pointsM[ref.piece + 1] - pointsM[ref.piece]);
    };
    for (const auto& [a, b] : PieceGrid(graph, places).pairs())
    {
        const auto& p = graph.chains[a.chain].points;
        const auto& q = graph.chains[b.chain].points;
        const std::uint32_t ends[] = {p[a.piece], p[a.piece + 1], q[b.piece], q[b.piece + 1]};
        if (ends[0] == ends[2] || ends[0] == ends[3] || ends[1] == ends[2] || ends[1] == ends[3]) continue;
        const auto shares =
            crossingShares(places[ends[0]], places[ends[1]], places[ends[2]], places[ends[3]]);
        if (!shares) continue;
        const int above = aboveOf(traits(a).level(), traits(b).level());
        Overpass pass{a.chain, b.chain, along(a, shares->x), along(b, shares->y)};
        if (!known.isNew(pass)) continue;
        pass.sine = sineBetween(places[ends[1]] - places[ends[0]], places[ends[3]] - places[ends[2]]);
        if (above == 0)
        {
            result.leftOpen.push_back(pass);
            continue;
        }
        const StreetTraits& below = above > 0 ? traits(b) : traits(a);
        if (below.isTrack && below.place == StreetPlace::tunnel)
            continue; // it has no place among what is seen
        if (above < 0) std::swap(pass.upper, pass.lower), std::swap(pass.upperM, pass.lowerM);
        const StreetTraits& over = above > 0 ? traits(a) : traits(b);
        const Separation wanted = separationOf(over, below);
        pass.isLowerTube = !below.isTrack && below.place == StreetPlace::tunnel;
        pass.isUpperLifted = over.place == StreetPlace::bridge || over.layer > 0;
        pass.isLowerSunk = below.place == StreetPlace::tunnel || below.layer < 0;
        pass.riseM = wanted.riseM, pass.clearM = wanted.clearM;
        result.found.push_back(pass);
    }
    return result;
}

} // namespace worldmaking
