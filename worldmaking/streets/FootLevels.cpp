// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/FootLevels.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "scenery/structures/Footbridge.h"
#include "worldmaking/streets/PathTags.h"
#include "worldmaking/streets/PlanPieces.h"

namespace worldmaking
{

namespace
{

constexpr double kFootFall = 0.1; ///< that a footbridge may have without stairs

/// Where a footbridge crosses a street or a railway.
struct FootCrossing
{
    std::size_t chain = 0;
    double chainM = 0.0, footM = 0.0; ///< along each
    double sine = 1.0;
    const StreetTraits* traits = nullptr;
    bool isFootAbove = true;
};

std::vector<FootCrossing> crossingsOf(const std::vector<glm::dvec2>& path, const WayLevel& level,
                                      const PlanPieces& pieces, const StreetGraph& graph,
                                      const std::vector<CentreLine>& lines)
{
    std::vector<FootCrossing> found;
    double startM = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
        const double lengthM = glm::distance(path[i], path[i + 1]);
        const auto take = [&](const PlanPiece& piece, const glm::dvec2& shares)
        {
            const StreetTraits& traits = graph.traitsAt(graph.chains[piece.chain], piece.piece);
            const int above = aboveOf(level, traits.level());
            if (above == 0 || traits.place == StreetPlace::tunnel) return;
            const auto& pointsM = lines[piece.chain].pointsM();
            found.push_back({piece.chain, std::lerp(pointsM[piece.piece], pointsM[piece.piece + 1], shares.x),
                             startM + shares.y * lengthM,
                             sineBetween(piece.to - piece.from, path[i + 1] - path[i]), &traits, above > 0});
        };
        pieces.crossing(path[i], path[i + 1], take);
        startM += lengthM;
    }
    return found;
}

} // namespace

double footbridgeAboveM(const StreetTraits& lower)
{
    constexpr double kWireRoomM = 6.2;
    const double roomM = !lower.isTrack ? kClearM : lower.hasWire ? kWireRoomM : kRailTopM + kClearM;
    return roomM + scenery::kFootDeckM + 0.1;
}

double footbridgeBelowM(const StreetTraits& upper)
{
    return kWalkersClearM + (upper.isTrack ? kTrackDeckM : kRoadDeckM);
}

std::vector<Overpass> footLevels(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                                 const std::vector<CentreLine>& lines, const LandMap& land,
                                 const MapPlane& plane)
{
    std::vector<Overpass> found;
    const PlanPieces pieces(graph, places);
    for (const LandShape& shape : land.shapes)
    {
        const WayLevel level = levelOf(shape.tags);
        if (shape.form != ShapeForm::line || level.place != StreetPlace::bridge || !isFootway(shape.tags))
            continue;
        const auto paths = plane.toPlan(shape.paths);
        if (!paths) continue;
        const auto crossed = crossingsOf(paths->front(), level, pieces, graph, lines);
        for (const FootCrossing& lower : crossed)
            for (const FootCrossing& upper : crossed)
            {
                if (!lower.isFootAbove || upper.isFootAbove || lower.chain == upper.chain) continue;
                Overpass pass{upper.chain, lower.chain, upper.chainM, lower.chainM, upper.sine};
                pass.clearM = kWalkersClearM;
                pass.riseM = footbridgeAboveM(*lower.traits) + footbridgeBelowM(*upper.traits) + kRoundingM -
                             kFootFall * std::fabs(upper.footM - lower.footM);
                pass.isUpperLifted = upper.traits->place == StreetPlace::bridge || upper.traits->layer > 0;
                pass.isLowerSunk = lower.traits->layer < 0;
                if (pass.riseM > 0.0) found.push_back(pass);
            }
    }
    return found;
}

} // namespace worldmaking
