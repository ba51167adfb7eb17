// SPDX-License-Identifier: Apache-2.0
#include "CrossSection.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr int kCurvedColumns = 9; ///< of a lane of a road whose cross-section is not straight
constexpr double kWidestPavedBorderM = 3.0;
constexpr double kInsideM = 1e-6; ///< heights of a border are asked for so far inside the lane

SurfaceKind kindOf(LaneType type)
{
    switch (type)
    {
    case LaneType::shoulder:
    case LaneType::border:
        return SurfaceKind::shoulder;
    case LaneType::curb:
        return SurfaceKind::kerb;
    case LaneType::sidewalk:
        return SurfaceKind::sidewalk;
    case LaneType::median:
    case LaneType::none:
        return SurfaceKind::grass;
    case LaneType::tram:
    case LaneType::rail:
        return SurfaceKind::gravel;
    default:
        return SurfaceKind::asphalt;
    }
}

/// A border is paved where it is no wider than a hard shoulder; a wider one is land that belongs to the road.
bool isWideBorder(const Lane& lane, double widthM)
{
    return lane.type == LaneType::border && widthM > kWidestPavedBorderM;
}

/// The kind of a lane: what its material says, else what its type means.
SurfaceKind kindOf(const Lane& lane, double widthM)
{
    const std::string_view word =
        lane.materials.empty() ? std::string_view() : lane.materials.front().restriction;
    if (word == "asphalt") return SurfaceKind::asphalt;
    if (word == "concrete") return SurfaceKind::concrete;
    if (word == "pavement" || word == "cobble") return SurfaceKind::sidewalk;
    if (word == "gravel" || word == "dirt" || word == "soil") return SurfaceKind::gravel;
    if (word == "vegetation" || word == "grass") return SurfaceKind::grass;
    return isWideBorder(lane, widthM) ? SurfaceKind::grass : kindOf(lane.type);
}

bool hasStepsIn(const LaneSection& section)
{
    const auto isRaised = [](const Lane& lane) { return !lane.heights.empty() || lane.isLevel; };
    return std::any_of(section.left.begin(), section.left.end(), isRaised) ||
           std::any_of(section.right.begin(), section.right.end(), isRaised);
}

/// The frame of a cross-section as far as it is tilted.
RoadFrame tiltAt(const Road& road, double s)
{
    return road.hasTilt() ? frameAt(road, s, {}) : RoadFrame{};
}

bool isCurved(const Road& road)
{
    const bool hasCrossfall = !road.crossfall.leftRad.isEmpty() || !road.crossfall.rightRad.isEmpty();
    return !road.shapes.empty() || (hasCrossfall && !road.laneOffset.isEmpty());
}

/// Returns the part of a way outwards from t that does not reach beyond the centre of a bend, where the
/// surface would fold over.
double unfolded(double leftM, double t, double curvature)
{
    constexpr double kShare = 0.98; // of the way to the centre
    if (curvature * leftM <= 0.0) return leftM;
    const double room = std::max(kShare / std::fabs(curvature) - std::fabs(t), 0.0);
    return std::copysign(std::min(std::fabs(leftM), room), leftM);
}

/// The lanes at one s, from right to left.
std::vector<LaneSpan> spansAcross(const Road& road, const LaneSection& section, double s)
{
    std::vector<LaneSpan> spans;
    const auto collect = [&](const LaneSpan& span)
    {
        spans.push_back(span);
        return true;
    };
    forLanesOutwards(road, section, -1, s, collect);
    std::reverse(spans.begin(), spans.end());
    forLanesOutwards(road, section, 1, s, collect);
    return spans;
}

/// Has the steps between lanes take their ends from their neighbours.
void setSteps(const std::vector<Strip>& strips, std::vector<SectionPoint>& points)
{
    std::size_t first = 0;
    for (const Strip& strip : strips)
    {
        if (strip.kind == SurfaceKind::kerb && !strip.lane)
        {
            points[first] = {points[first - 1].t, points[first - 1].h, 0.0, 0.0};
            points[first + 1] = {points[first + 2].t, points[first + 2].h, 0.0, 0.0};
        }
        first += static_cast<std::size_t>(strip.columns);
    }
}

} // namespace

CrossSection::CrossSection(const Road& road, const LaneSection& section, const RoadBed& bed)
    : _road(road), _section(section), _bed(bed), _hasSteps(hasStepsIn(section))
{
    const int columns = isCurved(road) ? kCurvedColumns : 2;
    _strips.push_back({.kind = SurfaceKind::skirt});
    _strips.push_back({.kind = SurfaceKind::verge});
    for (auto lane = section.right.rbegin(); lane != section.right.rend(); ++lane)
        addLane(*lane, columns);
    for (const Lane& lane : section.left)
        addLane(lane, columns);
    _strips.push_back({.kind = SurfaceKind::verge});
    _strips.push_back({.kind = SurfaceKind::skirt});
    const std::size_t leftVerge = _strips.size() - 2;
    for (const auto& [verge, beside] :
         {std::pair{std::size_t{1}, std::size_t{2}}, {leftVerge, leftVerge - 1}})
        if (_strips[beside].lane && isGround(_strips[beside].kind)) _strips[verge].kind = SurfaceKind::grass;
    for (const Strip& strip : _strips)
        _columns += static_cast<std::size_t>(strip.columns);
}

void CrossSection::addLane(const Lane& lane, int columns)
{
    if (_hasSteps && _strips.back().lane) _strips.push_back({.kind = SurfaceKind::kerb});
    const auto span = laneSpan(_road, lane.id, 0.5 * (_section.s + _section.end));
    Strip strip{.kind = kindOf(lane, span ? span->width() : 0.0), .lane = &lane, .columns = columns};
    const Lane* inner = _section.lane(lane.id > 0 ? lane.id - 1 : lane.id + 1);
    strip.rightMark = lane.id > 0 ? inner : &lane;
    strip.leftMark = lane.id > 0 ? &lane : inner;
    _strips.push_back(strip);
}

void CrossSection::pointsAt(double s, std::vector<SectionPoint>& points) const
{
    const std::vector<LaneSpan> spans = spansAcross(_road, _section, s);
    points.clear();
    std::size_t next = 0;
    for (const Strip& strip : _strips)
    {
        if (strip.lane)
        {
            const LaneSpan& span = spans[next++];
            const double right = std::min(span.innerT, span.outerT), width = span.width();
            const double inside = std::min(kInsideM, 0.25 * width);
            for (int i = 0; i < strip.columns; ++i)
            {
                const double across = width * i / (strip.columns - 1);
                const double t = right + std::clamp(across, inside, width - inside);
                points.push_back({right + across, surfaceHeight(_road, s, t), across, width});
            }
        }
        else
            points.insert(points.end(), 2, SectionPoint{});
    }
    // Verges take their ends from their neighbours.
    const double offset = _road.laneOffset.value(s);
    const auto edge = [&](bool isLeft)
    {
        if (spans.empty()) return SectionPoint{offset, surfaceHeight(_road, s, offset), 0.0, 0.0};
        return isLeft ? points[points.size() - 5] : points[4];
    };
    const SectionPoint right = edge(false), left = edge(true);
    const RoadFrame frame = tiltAt(_road, s);
    const double vergeFallM = _bed.vergeM * _bed.vergeFall, run = _bed.skirtM / _bed.skirtSlope;
    const double curvature = _road.referenceLine.at(s).curvature;
    const auto beside = [&](const SectionPoint& from, double leftM, double downM, double across, double width)
    {
        const glm::dvec2 to = frame.moved({from.t, from.h}, unfolded(leftM, from.t, curvature), downM);
        return SectionPoint{to.x, to.y, across, width};
    };
    const double outM = _bed.vergeM + run, downM = vergeFallM + _bed.skirtM;
    points[3] = beside(right, 0.0, 0.0, 0.0, _bed.vergeM);
    points[2] = beside(right, -_bed.vergeM, vergeFallM, _bed.vergeM, _bed.vergeM);
    points[1] = beside(right, -_bed.vergeM, vergeFallM, run, run);
    points[0] = beside(right, -outM, downM, 0.0, run);
    const std::size_t end = points.size();
    points[end - 4] = beside(left, 0.0, 0.0, 0.0, _bed.vergeM);
    points[end - 3] = beside(left, _bed.vergeM, vergeFallM, _bed.vergeM, _bed.vergeM);
    points[end - 2] = beside(left, _bed.vergeM, vergeFallM, 0.0, run);
    points[end - 1] = beside(left, outM, downM, run, run);
    setSteps(_strips, points);
}

} // namespace osgRoads::core
