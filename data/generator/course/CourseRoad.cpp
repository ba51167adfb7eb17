// SPDX-License-Identifier: Apache-2.0
#include "CourseRoad.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace islandgen
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::LineShape;
using osgRoads::core::PlanElement;

constexpr std::size_t kRoads = 4;
constexpr double kSightRadiusM = 250.0; ///< of wider bends one sees the end
constexpr double kBeforeBendM = 50.0;
constexpr double kRailHeightM = 2.0; ///< of the embankment
/// Cover of a portal, which is as high as its tube; of a place that deserves a tunnel; half a tube; before
/// the ends of a road.
constexpr double kPortalCoverM = 8.0, kTunnelCoverM = 12.0, kTubeM = 6.0, kPortalRoomM = 30.0;
constexpr double kShortestTunnelM = 40.0, kTunnelStepM = 2.0;
constexpr double kFootM = 9.0, kRailStepM = 10.0, kShortestRailM = 50.0;

/// The middles of the straights nearest to equal parts of the course.
std::vector<double> cutsOf(const Alignment& alignment)
{
    std::vector<double> cuts;
    for (std::size_t i = 0; i < kRoads; ++i)
    {
        const double wantedM = alignment.lengthM * (static_cast<double>(i) + 0.5) / kRoads;
        double bestM = -alignment.lengthM;
        for (const PlanElement& element : alignment.elements)
            if (std::holds_alternative<LineShape>(element.shape()))
                if (const double middleM = element.s + 0.5 * element.length;
                    std::abs(middleM - wantedM) < std::abs(bestM - wantedM))
                    bestM = middleM;
        cuts.push_back(bestM);
    }
    return cuts;
}

/// Adds what of an element lies between two places of the course; only straights are cut.
void addElement(CourseRoad& road, const PlanElement& element, double startM, double fromM, double toM)
{
    const double low = std::max(startM, fromM), high = std::min(startM + element.length, toM);
    if (high - low < 1e-6) return;
    const auto start = element.at(low - startM);
    road.elements.emplace_back(low - fromM, high - low, start.position, start.headingRad, element.shape());
}

/// Adds what of a piece lies behind the start of a road.
void addPiece(std::vector<Cubic>& pieces, const Cubic& piece, double fromM)
{
    const double at = std::max(piece.s, fromM), ds = at - piece.s;
    if (!pieces.empty() && at == fromM) pieces.clear();
    pieces.push_back({at - fromM, piece.value(at), piece.slope(at), piece.c + 3.0 * piece.d * ds, piece.d});
}

CubicProfile elevationOf(const CubicProfile& profile, double fromM, double toM)
{
    std::vector<Cubic> pieces;
    for (const Cubic& piece : profile.pieces())
        if (piece.s < toM) addPiece(pieces, piece, fromM);
    return CubicProfile(std::move(pieces));
}

/// The bends lean inwards: 2 % where they are wide, 6 % where they are tight, and their spirals lead over.
CubicProfile superelevationOf(const std::vector<Bend>& bends)
{
    std::vector<Cubic> pieces{{0.0, 0.0, 0.0, 0.0, 0.0}};
    for (const Bend& bend : bends)
    {
        const double lean =
            std::atan(std::clamp(9.0 / bend.radiusM, 0.02, 0.06)) * (bend.isLeft ? -1.0 : 1.0);
        pieces.push_back({bend.startM, 0.0, lean / bend.spiralM, 0.0, 0.0});
        pieces.push_back({bend.startM + bend.spiralM, lean, 0.0, 0.0, 0.0});
        pieces.push_back({bend.endM - bend.spiralM, lean, -lean / bend.spiralM, 0.0, 0.0});
        pieces.push_back({bend.endM, 0.0, 0.0, 0.0, 0.0});
    }
    return CubicProfile(std::move(pieces));
}

std::vector<Stretch> noOvertakingOf(const CourseRoad& road)
{
    std::vector<Stretch> stretches;
    for (const Bend& bend : road.bends)
    {
        if (bend.radiusM > kSightRadiusM) continue;
        const Stretch next{std::max(0.0, bend.startM - kBeforeBendM),
                           std::min(road.lengthM, bend.endM + kBeforeBendM)};
        if (!stretches.empty() && next.fromM - stretches.back().toM < kBeforeBendM)
            stretches.back().toM = next.toM;
        else
            stretches.push_back(next);
    }
    return stretches;
}

/// Finds where the ground beside the road lies deep below it. `side`: 1 left, -1 right.
std::vector<Stretch> railsOf(const Terrain& terrain, const CourseRoad& road, double side)
{
    const osgRoads::core::ReferenceLine line(road.elements);
    std::vector<Stretch> stretches;
    for (double s = kRailStepM; s < road.lengthM - kRailStepM; s += kRailStepM)
    {
        const auto point = line.at(s);
        const glm::dvec2 left(-std::sin(point.headingRad), std::cos(point.headingRad));
        const double groundM = groundAt(terrain, point.position + side * kFootM * left);
        if (road.elevation.value(s) - groundM < kRailHeightM) continue;
        if (!stretches.empty() && s - stretches.back().toM < 4.0 * kRailStepM)
            stretches.back().toM = s;
        else
            stretches.push_back({s - kRailStepM, s});
    }
    std::erase_if(stretches, [](const Stretch& rail) { return rail.toM - rail.fromM < kShortestRailM; });
    return stretches;
}

/// By how much the ground covers the road at s: the least over its middle and both sides of a tube.
double coverAt(const Terrain& terrain, const CourseRoad& road, const osgRoads::core::ReferenceLine& line,
               double s)
{
    const auto point = line.at(s);
    const glm::dvec2 left(-std::sin(point.headingRad), std::cos(point.headingRad));
    double leastM = 1e9;
    for (const double side : {-kTubeM, 0.0, kTubeM})
        leastM = std::min(leastM, groundAt(terrain, point.position + side * left));
    return leastM - road.elevation.value(s);
}

/// Finds where a tunnel is in place of a cutting: long enough under ground that covers its tube, and
/// somewhere deep.
std::vector<Stretch> tunnelsOf(const Terrain& terrain, const CourseRoad& road)
{
    const osgRoads::core::ReferenceLine line(road.elements);
    std::vector<Stretch> stretches;
    double deepestM = 0.0;
    Stretch here{-1.0, -1.0};
    for (double s = kPortalRoomM; s < road.lengthM - kPortalRoomM; s += kTunnelStepM)
    {
        const double coverM = coverAt(terrain, road, line, s);
        if (coverM >= kPortalCoverM)
        {
            here = {here.fromM < 0.0 ? s : here.fromM, s};
            deepestM = std::max(deepestM, coverM);
            continue;
        }
        if (here.toM - here.fromM >= kShortestTunnelM && deepestM >= kTunnelCoverM) stretches.push_back(here);
        here = {-1.0, -1.0};
        deepestM = 0.0;
    }
    return stretches;
}

} // namespace

std::vector<CourseRoad> roadsOf(const Terrain& terrain, const Alignment& alignment,
                                const CourseHeights& heights)
{
    const CubicProfile profile = profileOf(heights, alignment.lengthM);
    std::vector<double> cuts = cutsOf(alignment);
    cuts.push_back(cuts.front() + alignment.lengthM);
    std::vector<CourseRoad> roads(kRoads);
    for (std::size_t i = 0; i < kRoads; ++i)
    {
        CourseRoad& road = roads[i];
        const double fromM = cuts[i], toM = cuts[i + 1];
        road.lengthM = toM - fromM;
        for (const double lapM : {0.0, alignment.lengthM})
        {
            for (const PlanElement& element : alignment.elements)
                addElement(road, element, element.s + lapM, fromM, toM);
            for (Bend bend : alignment.bends)
            {
                bend.startM += lapM - fromM;
                bend.endM += lapM - fromM;
                if (bend.startM >= 0.0 && bend.endM <= road.lengthM) road.bends.push_back(bend);
            }
        }
        road.elevation = elevationOf(profile, fromM, toM);
        road.superelevationRad = superelevationOf(road.bends);
        road.noOvertaking = noOvertakingOf(road);
        road.tunnels = tunnelsOf(terrain, road);
        road.leftRail = railsOf(terrain, road, 1.0);
        road.rightRail = railsOf(terrain, road, -1.0);
    }
    return roads;
}

} // namespace islandgen
