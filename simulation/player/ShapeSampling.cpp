// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ShapeSampling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/player/NurbsCurve.h"

namespace simulation
{
namespace
{

constexpr double kSampleM = 0.1;
constexpr double kMostSamples = 20000.0;
constexpr double kAhead =
    0.3; ///< of a sample: how far before a NURBS is looked at, by esmini's track of trajectory-test

int samplesFor(double lengthM)
{
    return static_cast<int>(std::clamp(std::ceil(lengthM / kSampleM), 1.0, kMostSamples));
}

void addSample(Polyline& polyline, const glm::dvec3& point, double headingRad, std::optional<double> timeS)
{
    Orientation orientation;
    orientation.headingRad = headingRad;
    polyline.vertices.push_back(
        {polyline.source, timeS, WorldPosition{polyline.source, point.x, point.y, point.z, orientation}});
}

/// A clothoid between two times, from a place on.
struct ClothoidPiece
{
    double curvature = 0.0, curvaturePrime = 0.0, lengthM = 0.0;
    std::optional<double> fromS, toS;
};

/// Samples a clothoid and moves the pose to its end. The way from sample to sample is integrated by three
/// points of Gauss.
void addClothoid(Polyline& polyline, const ClothoidPiece& piece, Placement& pose)
{
    static constexpr std::array<double, 3> kNodes = {0.1127016653792583, 0.5, 0.8872983346207417};
    static constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    const int count = samplesFor(piece.lengthM);
    const double step = piece.lengthM / count;
    const double startHeading = pose.headingRad;
    const auto headingAt = [&](double s)
    { return startHeading + s * (piece.curvature + 0.5 * piece.curvaturePrime * s); };
    const auto timeAt = [&](int i) -> std::optional<double>
    {
        if (!piece.fromS || !piece.toS) return std::nullopt;
        return *piece.fromS + (*piece.toS - *piece.fromS) * i / count;
    };
    // Where one ends the next one begins: that sample is there already.
    if (polyline.vertices.empty() || !(timeAt(0) == polyline.vertices.back().timeS) || !piece.fromS)
        addSample(polyline, pose.position, pose.headingRad, timeAt(0));
    for (int i = 0; i < count; ++i)
    {
        for (std::size_t node = 0; node < kNodes.size(); ++node)
        {
            const double heading = headingAt(step * (i + kNodes[node]));
            pose.position += glm::dvec3(std::cos(heading), std::sin(heading), 0.0) * (step * kWeights[node]);
        }
        pose.headingRad = headingAt(step * (i + 1));
        addSample(polyline, pose.position, pose.headingRad, timeAt(i + 1));
    }
}

std::optional<Polyline> sampled(const Clothoid& clothoid, const PositionSolver& positions, const EntityState*)
{
    std::optional<Placement> pose = positions.place(clothoid.start);
    if (!pose) return std::nullopt;
    Polyline polyline{clothoid.source, {}, clothoid.lengthM};
    addClothoid(polyline,
                {clothoid.curvature, clothoid.curvaturePrime, clothoid.lengthM, clothoid.startTimeS,
                 clothoid.stopTimeS},
                *pose);
    return polyline;
}

std::optional<Polyline> sampled(const ClothoidSpline& spline, const PositionSolver& positions,
                                const EntityState* actor)
{
    std::optional<Placement> pose;
    if (actor)
    {
        pose.emplace();
        pose->position = actor->position;
        pose->headingRad = foundation::radiansOf(actor->headingDeg);
    }
    Polyline polyline{spline.source, {}, 0.0};
    for (std::size_t i = 0; i < spline.segments.size(); ++i)
    {
        const ClothoidSpline::Segment& segment = spline.segments[i];
        if (segment.start) pose = positions.place(*segment.start);
        if (!pose) return std::nullopt;
        pose->headingRad += segment.headingOffsetRad;
        *polyline.lengthM += segment.lengthM;
        const std::optional<double> end =
            i + 1 < spline.segments.size() ? spline.segments[i + 1].timeStartS : spline.timeEndS;
        addClothoid(polyline,
                    {segment.curvatureStart,
                     (segment.curvatureEnd - segment.curvatureStart) / segment.lengthM, segment.lengthM,
                     segment.timeStartS, end},
                    *pose);
    }
    return polyline;
}

/// The parameters of the samples at which the basis functions of the points are greatest: the last one not
/// far behind the peak.
std::vector<double> parametersOfPeaks(const NurbsCurve& curve, std::size_t points, int samples)
{
    std::vector<double> peaks(points, curve.begin());
    std::vector<double> greatest(points, -1.0);
    const double ahead = kAhead * (curve.end() - curve.begin()) / samples;
    for (int k = 0; k <= samples; ++k)
    {
        const double u = curve.begin() + (curve.end() - curve.begin()) * k / samples;
        for (std::size_t i = 0; i < points; ++i)
            if (const double value = curve.basis(i, u + ahead); value > greatest[i])
            {
                greatest[i] = value;
                peaks[i] = u;
            }
    }
    return peaks;
}

double timeBetween(const Nurbs& nurbs, const std::vector<double>& peaks, double u)
{
    std::size_t i = 0;
    while (i + 2 < peaks.size() && u > peaks[i + 1])
        ++i;
    const double width = peaks[i + 1] - peaks[i];
    const double share = width > 0.0 ? std::clamp((u - peaks[i]) / width, 0.0, 1.0) : 1.0;
    return *nurbs.points[i].timeS + share * (*nurbs.points[i + 1].timeS - *nurbs.points[i].timeS);
}

std::optional<Polyline> sampled(const Nurbs& nurbs, const PositionSolver& positions, const EntityState*)
{
    constexpr int kFewestSamples = 20;
    std::vector<glm::dvec3> places;
    double length = 0.0;
    bool isTimed = true;
    for (const Nurbs::ControlPoint& point : nurbs.points)
    {
        const std::optional<Placement> placed = positions.place(point.position);
        if (!placed) return std::nullopt;
        if (!places.empty()) length += glm::length(placed->position - places.back());
        places.push_back(placed->position);
        isTimed = isTimed && point.timeS;
    }
    const glm::dvec3 origin = places.front();
    std::vector<glm::dvec4> points;
    for (std::size_t i = 0; i < places.size(); ++i)
        points.emplace_back((places[i] - origin) * nurbs.points[i].weight, nurbs.points[i].weight);
    const NurbsCurve curve(std::move(points), nurbs.knots, nurbs.order - 1);
    const int count =
        static_cast<int>(std::clamp(1.0 + std::floor(length), 1.0 * kFewestSamples, kMostSamples));
    const std::vector<double> peaks =
        isTimed ? parametersOfPeaks(curve, places.size(), count) : std::vector<double>();
    Polyline polyline{nurbs.source, {}};
    // Directions look a little ahead, as esmini's do.
    const double step = (curve.end() - curve.begin()) / count;
    double heading = 0.0;
    for (int k = 0; k <= count; ++k)
    {
        const double u = curve.begin() + step * k;
        // The first looks along the line to the next, the others a little ahead.
        const glm::dvec3 along = k == 0 ? curve.at(u + step) - curve.at(u)
                                        : curve.tangentAt(u + (k < count ? 0.5 * kAhead : 0.0) * step);
        if (std::hypot(along.x, along.y) > 0.0) heading = std::atan2(along.y, along.x);
        addSample(polyline, origin + curve.at(u), heading,
                  isTimed ? std::optional(timeBetween(nurbs, peaks, u)) : std::nullopt);
    }
    return polyline;
}

std::optional<Polyline> sampled(const Polyline& polyline, const PositionSolver& positions, const EntityState*)
{
    Polyline placed{polyline.source, {}};
    for (const Vertex& vertex : polyline.vertices)
    {
        const auto found = positions.place(vertex.position);
        if (!found) return std::nullopt;
        WorldPosition world{vertex.source, found->position.x, found->position.y, found->position.z, {}};
        if (found->hasHeading) world.orientation.headingRad = found->headingRad;
        placed.vertices.push_back({vertex.source, vertex.timeS, world});
    }
    return placed;
}

std::optional<Polyline> sampled(const Unsupported&, const PositionSolver&, const EntityState*)
{
    return std::nullopt;
}

glm::dvec3 pointOf(const Vertex& vertex)
{
    const auto& world = std::get<WorldPosition>(vertex.position);
    return {world.xM, world.yM, world.zM.value_or(0.0)};
}

} // namespace

std::optional<Polyline> sampledShape(const TrajectoryShape& shape, const PositionSolver& positions,
                                     const EntityState* actor)
{
    return std::visit([&](const auto& content) { return sampled(content, positions, actor); }, shape);
}

std::optional<Placement> placeOnTrajectory(const TrajectoryPosition& position,
                                           const PositionSolver& positions)
{
    const std::optional<Polyline> polyline = sampledShape(position.trajectory->shape, positions, nullptr);
    if (!polyline || polyline->vertices.size() < 2) return std::nullopt;
    double left = position.sM;
    for (std::size_t i = 0; i + 1 < polyline->vertices.size(); ++i)
    {
        const glm::dvec3 from = pointOf(polyline->vertices[i]);
        const glm::dvec3 along = pointOf(polyline->vertices[i + 1]) - from;
        const double length = glm::length(along);
        const bool isLast = i + 2 == polyline->vertices.size();
        if (!(length > 0.0) || (left > length && !isLast))
        {
            left -= length;
            continue;
        }
        const double heading = std::atan2(along.y, along.x);
        Placement placed;
        placed.position = from + along * std::min(left / length, 1.0) +
                          glm::dvec3(-std::sin(heading), std::cos(heading), 0.0) * position.tM;
        placed.headingRad =
            position.orientation.headingRad.value_or(0.0) + (position.orientation.isRelative ? heading : 0.0);
        placed.pitchRad = position.orientation.pitchRad.value_or(0.0);
        placed.rollRad = position.orientation.rollRad.value_or(0.0);
        placed.hasHeading = true;
        return placed;
    }
    return std::nullopt;
}

} // namespace simulation
