// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/CrossedWays.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "worldmaking/land/PlanGrid.h"
#include "worldmaking/streets/Overpass.h"

namespace worldmaking
{

namespace
{

constexpr double kPathClearM = 2.5, kWaterClearM = 0.9, kSmallRoundM = 0.7;
constexpr double kSamePlaceM = 0.05;

bool isOneWord(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

double widthOf(const Tags& tags, double otherwiseM)
{
    const std::string_view text = valueOf(tags, "width");
    double widthM = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), widthM);
    return read.ec == std::errc() && widthM > 0.5 && widthM < 500.0 ? widthM : otherwiseM;
}

/// What a line of a map is to a street.
struct CrossedLine
{
    CrossedKind kind = CrossedKind::path;
    double widthM = 2.0;
    bool isLarge = false; ///< water that no culvert takes
};

std::optional<CrossedLine> crossedLineOf(const Tags& tags)
{
    if (isOneWord(valueOf(tags, "highway"),
                  {"path", "footway", "cycleway", "track", "bridleway", "pedestrian"}))
        return CrossedLine{CrossedKind::path, widthOf(tags, 2.5)};
    const std::string_view water = valueOf(tags, "waterway"), air = valueOf(tags, "aeroway");
    if (isOneWord(water, {"river", "canal"}))
        return CrossedLine{CrossedKind::water, widthOf(tags, 10.0), true};
    if (isOneWord(water, {"stream", "ditch", "drain", "brook"}))
        return CrossedLine{CrossedKind::water, widthOf(tags, 2.0)};
    if (air == "runway") return CrossedLine{CrossedKind::airway, widthOf(tags, 45.0) + 40.0};
    if (air == "taxiway") return CrossedLine{CrossedKind::airway, widthOf(tags, 18.0) + 12.0};
    return std::nullopt;
}

/// Whether the street passes over a line, 1, or under it, -1; 0: neither concerns its height.
int sideOf(const StreetTraits& street, const CrossedLine& line, const WayLevel& level)
{
    const bool isLifted = street.place == StreetPlace::bridge || street.layer > 0;
    switch (line.kind)
    {
    case CrossedKind::path:
        return isLifted && level.place != StreetPlace::tunnel && aboveOf(street.level(), level) > 0 ? 1 : 0;
    case CrossedKind::water:
        if (level.place == StreetPlace::tunnel || street.place == StreetPlace::tunnel) return 0;
        if (aboveOf(street.level(), level) < 0) return 0; // an aqueduct
        return isLifted || line.isLarge ? 1 : 0;
    case CrossedKind::airway:
        return aboveOf(level, street.level()) > 0 ? -1 : 0;
    }
    return 0;
}

double apartOf(CrossedKind kind)
{
    if (kind == CrossedKind::airway) return kTunnelRoofM;
    return kRoadDeckM + kSmallRoundM + (kind == CrossedKind::path ? kPathClearM : kWaterClearM);
}

struct PlanPiece
{
    std::size_t chain = 0, piece = 0;
    glm::dvec2 from{0.0}, to{0.0};
};

/// The pieces of streets, by a grid.
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

    /// Calls `use(piece, share of it, share of the line)` for each piece that a line crosses, but at points
    /// in common.
    template<class Use>
    void crossing(const glm::dvec2& from, const glm::dvec2& to, const Use& use) const
    {
        const auto look = [&](std::size_t i)
        {
            const PlanPiece& piece = _pieces[i];
            const auto shares = crossingShares(piece.from, piece.to, from, to);
            if (!shares) return;
            const glm::dvec2 at = glm::mix(from, to, shares->y);
            const auto isAt = [&](const glm::dvec2& end) { return glm::distance(end, at) < kSamePlaceM; };
            if ((isAt(from) || isAt(to)) && (isAt(piece.from) || isAt(piece.to))) return;
            use(piece, *shares);
        };
        _grid.near({glm::min(from, to), glm::max(from, to)}, look);
    }

private:
    std::vector<PlanPiece> _pieces;
    PlanGrid _grid;
};

} // namespace

std::vector<CrossedPlace> crossedPlaces(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                                        const std::vector<CentreLine>& lines, const LandMap& land,
                                        const MapPlane& plane)
{
    std::vector<CrossedPlace> found;
    const PlanPieces pieces(graph, places);
    for (const LandShape& shape : land.shapes)
    {
        if (shape.form != ShapeForm::line) continue;
        const auto line = crossedLineOf(shape.tags);
        const auto paths = line ? plane.toPlan(shape.paths) : std::nullopt;
        if (!paths) continue;
        const WayLevel level = levelOf(shape.tags);
        const auto& path = paths->front();
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            pieces.crossing(path[i], path[i + 1],
                            [&](const PlanPiece& piece, const glm::dvec2& shares)
                            {
                                const auto& chain = graph.chains[piece.chain];
                                const int side = sideOf(graph.traitsAt(chain, piece.piece), *line, level);
                                if (side == 0) return;
                                const auto& pointsM = lines[piece.chain].pointsM();
                                const double sine =
                                    std::max(0.3, sineBetween(piece.to - piece.from, path[i + 1] - path[i]));
                                found.push_back(
                                    {line->kind, piece.chain,
                                     std::lerp(pointsM[piece.piece], pointsM[piece.piece + 1], shares.x),
                                     0.5 * line->widthM / sine, glm::mix(path[i], path[i + 1], shares.y),
                                     side > 0, apartOf(line->kind), shape.id});
                            });
    }
    return found;
}

} // namespace worldmaking
