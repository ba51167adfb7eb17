// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/CornerEdge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "worldmaking/streets/BendRoom.h"
#include "worldmaking/streets/ConnectingRoad.h"
#include "worldmaking/streets/LaneLayout.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::Lane;
using osgRoads::core::LaneSpan;
using osgRoads::core::LaneType;
using osgRoads::core::Road;

constexpr double kLeastStripM = 0.01;
constexpr double kFillStepM = 4.0;    ///< that of the heights of connecting roads
constexpr double kFillOverlapM = 0.5; ///< over the paving of the next corner
constexpr double kFillTurnRad = 0.35; ///< and in bends no longer than this
constexpr double kFillErrorM = 0.15;  ///< of its width
constexpr double kLeastFillM = 0.02;  ///< a piece of it
/// around a corner, beyond which the tip between both streets is narrow
constexpr double kAcuteTurnRad = 2.0;
constexpr double kFarM = 1e9;
constexpr double kFoldShare = 0.9; ///< of the way to the centre of a bend

/// What lies beside the carriageway on one side. `sign`: 1 to the left.
ArmSide sideAt(const Road& road, const osgRoads::core::LaneSection& section, int sign, double s)
{
    ArmSide side;
    double edgeT = road.laneOffset.value(s);
    osgRoads::core::forLanesOutwards(road, section, sign, s,
                                     [&](const LaneSpan& span)
                                     {
                                         if (span.lane->type == LaneType::shoulder)
                                             side.shoulderM += span.width();
                                         else if (span.lane->type == LaneType::sidewalk)
                                             side.sidewalkM += span.width();
                                         else
                                             edgeT = span.outerT;
                                         return true;
                                     });
    const auto frame = osgRoads::core::frameAt(road, s);
    side.edge = glm::dvec2(frame.pointAt(edgeT, 0.0));
    // Traffic to the right of which the side lies goes along the road on its right, against it on its left.
    side.headingRad = frame.headingRad + (sign > 0 ? std::numbers::pi : 0.0);
    return side;
}

/// Whether a point lies beyond a border and on the inner side of it: within the arm.
bool isWithinArm(const ArmSide& side, double towardsArm, const glm::dvec2& point)
{
    const glm::dvec2 along(std::cos(side.headingRad), std::sin(side.headingRad)), left(-along.y, along.x);
    const glm::dvec2 way = point - side.edge;
    return towardsArm * glm::dot(way, along) > 0.0 && glm::dot(way, left) > 0.0;
}

/// What lies outside of the lanes of a road that there are so far.
Lane stripOf(const Road& road, LaneType type, double fromM, double toM)
{
    const double rise = toM - fromM, lengthM = road.length;
    const auto& inside = road.sections.front().right;
    const auto insideM = [&](double s)
    {
        double widthM = 0.0;
        for (const Lane& lane : inside)
            widthM += lane.width.value(s);
        return widthM;
    };
    Lane lane;
    lane.type = type;
    lane.width = widthInBend(
        road,
        Cubic{0.0, fromM, 0.0, 3.0 * rise / (lengthM * lengthM), -2.0 * rise / (lengthM * lengthM * lengthM)},
        insideM);
    return lane;
}

/// The kerb sinks to the ground where the sidewalk ends.
std::vector<osgRoads::core::LaneHeight> kerbHeights(double fromM, double toM, double lengthM)
{
    const auto heightOf = [](double widthM) { return widthM >= kLeastStripM ? kKerbM : 0.0; };
    return {{0.0, heightOf(fromM), heightOf(fromM)}, {lengthM, heightOf(toM), heightOf(toM)}};
}

/// How far a ray goes until it meets a half-line; nothing where it passes it.
std::optional<double> distanceToHalfLine(const glm::dvec2& from, const glm::dvec2& way, const HalfLine& line)
{
    const double sine = way.x * line.way.y - way.y * line.way.x;
    if (std::fabs(sine) < 1e-9) return std::nullopt;
    const glm::dvec2 between = line.start - from;
    const double along = (between.x * line.way.y - between.y * line.way.x) / sine;
    const double beyond = (between.x * way.y - between.y * way.x) / sine;
    return along > 0.0 && beyond >= 0.0 ? std::optional(along) : std::nullopt;
}

/// How far it is from a road to the nearer line of the streets on its left, and a little beyond.
double fillWidthM(const Road& road, double s, const CornerLines& lines)
{
    const auto point = road.referenceLine.at(s);
    const glm::dvec2 tangent = point.tangent(), left(-tangent.y, tangent.x);
    const auto first = distanceToHalfLine(point.position, left, lines.from),
               second = distanceToHalfLine(point.position, left, lines.to);
    if (!first && !second) return 0.0;
    const double lineM = std::min(first.value_or(kFarM), second.value_or(kFarM));
    const double widthM = lineM + std::min(lineM, kFillOverlapM);
    return point.curvature > 0.0 ? std::min(widthM, kFoldShare / point.curvature) : widthM;
}

/// Fills in from one place of a road to another; round an acute corner two pieces where one leaves the width
/// by more than kFillErrorM.
void addFill(const Road& road, const CornerLines& lines, double from, double to, bool isAcute,
             std::vector<Cubic>& pieces)
{
    const double stepM = to - from, away = 0.01 * stepM;
    const double start = fillWidthM(road, from, lines), end = fillWidthM(road, to, lines);
    // Between its ends a piece stays between their widths.
    const double most = 3.0 * (end - start) / stepM;
    const auto kept = [most](double slope)
    { return std::clamp(slope, std::min(most, 0.0), std::max(most, 0.0)); };
    const Cubic piece =
        hermitePiece(from, stepM, start, kept((fillWidthM(road, from + away, lines) - start) / away), end,
                     kept((end - fillWidthM(road, to - away, lines)) / away));
    const auto errorAt = [&](double share)
    {
        const double ds = share * stepM, width = piece.a + ds * (piece.b + ds * (piece.c + ds * piece.d));
        return std::fabs(width - fillWidthM(road, from + ds, lines));
    };
    if (isAcute && stepM > 2.0 * kLeastFillM &&
        std::max({errorAt(0.25), errorAt(0.5), errorAt(0.75)}) > kFillErrorM)
    {
        addFill(road, lines, from, 0.5 * (from + to), isAcute, pieces);
        addFill(road, lines, 0.5 * (from + to), to, isAcute, pieces);
        return;
    }
    pieces.push_back(piece);
}

/// Where the middle of the crossing lies straight to the left of a road between two places; nothing where it
/// does not.
std::optional<double> abreastOf(const Road& road, const glm::dvec2& middle, double from, double to)
{
    const auto ahead = [&](double s)
    {
        const auto point = road.referenceLine.at(s);
        return glm::dot(middle - point.position, point.tangent());
    };
    const double before = ahead(from);
    if (before * ahead(to) >= 0.0) return std::nullopt;
    for (int i = 0; i < 40; ++i)
        (ahead(0.5 * (from + to)) * before > 0.0 ? from : to) = 0.5 * (from + to);
    return from;
}

/// The paved lane between a road and the lines of the streets that it joins.
Lane fillOf(const Road& road, const CornerLines& lines)
{
    const double turnRad = std::fabs(foundation::wrappedRad(road.referenceLine.at(road.length).headingRad -
                                                            road.referenceLine.at(0.0).headingRad));
    const int count = std::max(
        {1, static_cast<int>(std::ceil(road.length / kFillStepM)), static_cast<int>(turnRad / kFillTurnRad)});
    const double stepM = road.length / count;
    const bool isAcute = turnRad > kAcuteTurnRad;
    std::vector<Cubic> pieces;
    for (int k = 0; k < count; ++k)
    {
        const double from = k * stepM, to = from + stepM;
        const auto tip = isAcute ? abreastOf(road, lines.from.start, from, to) : std::nullopt;
        const bool isWithin = tip && *tip > from + kLeastFillM && *tip < to - kLeastFillM;
        if (isWithin) addFill(road, lines, from, *tip, isAcute, pieces);
        addFill(road, lines, isWithin ? *tip : from, to, isAcute, pieces);
    }
    Lane lane;
    lane.id = 1;
    lane.type = LaneType::special;
    lane.width = CubicProfile(std::move(pieces));
    return lane;
}

} // namespace

ArmSides sidesOf(const Road& road, bool isEnd)
{
    const double s = isEnd ? road.length : 0.0;
    const auto& section = isEnd ? road.sections.back() : road.sections.front();
    const ArmSide right = sideAt(road, section, -1, s), left = sideAt(road, section, 1, s);
    return isEnd ? ArmSides{right, left} : ArmSides{left, right};
}

bool haveCorner(const ArmSide& from, const ArmSide& to)
{
    return !isWithinArm(from, -1.0, to.edge) && !isWithinArm(to, 1.0, from.edge);
}

void addEdge(Road& road, const ArmSide& from, const ArmSide& to, const CornerLines& lines)
{
    auto& section = road.sections.front();
    if (std::max(from.shoulderM, to.shoulderM) >= kLeastStripM)
        section.right.push_back(stripOf(road, LaneType::special, from.shoulderM, to.shoulderM));
    if (std::max(from.sidewalkM, to.sidewalkM) >= kLeastStripM)
    {
        section.right.push_back(stripOf(road, LaneType::sidewalk, from.sidewalkM, to.sidewalkM));
        section.right.back().heights = kerbHeights(from.sidewalkM, to.sidewalkM, road.length);
    }
    for (std::size_t i = 0; i < section.right.size(); ++i)
        section.right[i].id = -static_cast<int>(i) - 1;
    section.left = {fillOf(road, lines)};
}

} // namespace worldmaking
