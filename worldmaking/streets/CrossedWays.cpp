// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/CrossedWays.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <foundation/TagQuantity.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scenery/buildings/Outline.h"
#include "worldmaking/plan/Waters.h"
#include "worldmaking/streets/Overpass.h"
#include "worldmaking/streets/PathTags.h"
#include "worldmaking/streets/PlanPieces.h"

namespace worldmaking
{

namespace
{

constexpr double kPathClearM = 2.5, kWaterClearM = 0.9, kSmallRoundM = 0.7;

bool isOneWord(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

double widthOf(const Tags& tags, double otherwiseM)
{
    const auto widthM = foundation::metresOfTag(valueOf(tags, "width"));
    return widthM && *widthM > 0.5 && *widthM < 500.0 ? *widthM : otherwiseM;
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
    if (isFootway(tags)) return CrossedLine{CrossedKind::path, widthOf(tags, 2.5)};
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

/// Where bridges stand over an area of water: places along them, so that all of it keeps clear.
void addWater(const LandShape& water, const PlanPieces& pieces, const StreetGraph& graph,
              const std::vector<CentreLine>& lines, const MapPlane& plane, std::vector<CrossedPlace>& found)
{
    constexpr double kEachM = 5.0;
    const auto rings = plane.toPlan(water.paths);
    if (!rings) return;
    const WayLevel level = levelOf(water.tags);
    const auto look = [&](const PlanPiece& piece)
    {
        const StreetTraits& traits = graph.traitsAt(graph.chains[piece.chain], piece.piece);
        if (traits.place != StreetPlace::bridge || aboveOf(traits.level(), level) < 0) return;
        const auto& pointsM = lines[piece.chain].pointsM();
        const double lengthM = glm::distance(piece.from, piece.to);
        const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / kEachM)));
        for (int step = 0; step < steps; ++step)
        {
            const double share = (step + 0.5) / steps;
            const glm::dvec2 place = glm::mix(piece.from, piece.to, share);
            if (!scenery::isWithin(*rings, place)) continue;
            found.push_back({CrossedKind::water, piece.chain,
                             std::lerp(pointsM[piece.piece], pointsM[piece.piece + 1], share),
                             0.5 * lengthM / steps, place, true, apartOf(CrossedKind::water), water.id});
        }
    };
    pieces.near(boxOf(rings->front()), look);
}

} // namespace

std::vector<CrossedPlace> crossedPlaces(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                                        const std::vector<CentreLine>& lines, const LandMap& land,
                                        const MapPlane& plane)
{
    std::vector<CrossedPlace> found;
    const PlanPieces pieces(graph, places);
    for (const LandShape& shape : land.shapes)
    {
        if (isWater(shape)) addWater(shape, pieces, graph, lines, plane, found);
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
