// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackClearance.h"

#include <algorithm>
#include <cmath>

#include "simulation/player/PathCurve.h"

namespace simulation
{
namespace
{

constexpr double kClearanceSampleM = 15.0;
constexpr double kMostClearanceSamples = 64.0;
constexpr double kAllowedM = 0.05;
constexpr int kMostLiftRounds = 10;
constexpr double kLeastStepS = 1e-3; ///< between a new vertex and its neighbours
constexpr double kLeastStepM = 1e-3;

struct PlacedPath
{
    std::vector<PathVertex> vertices;
    std::vector<std::size_t> sources; ///< the vertex of the polyline for each
};

/// Parameters are times, or ways along the chords; a place twice counts once then.
PlacedPath placed(const FollowTrajectoryAction& action, const SceneFrame& frame)
{
    PlacedPath path;
    const std::vector<Vertex>& vertices = std::get<Polyline>(action.trajectory.shape).vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        PathVertex vertex{vertices[i].timeS.value_or(0.0), frame.place(vertices[i].position),
                          orientationOf(vertices[i].position)};
        if (!action.timing && !path.vertices.empty())
        {
            const double chord = glm::distance(vertex.position, path.vertices.back().position);
            if (chord < kLeastStepM) continue;
            vertex.parameter = path.vertices.back().parameter + chord;
        }
        path.vertices.push_back(vertex);
        path.sources.push_back(i);
    }
    return path;
}

/// A place on the curve that is below the ground.
struct Dip
{
    double parameter = 0.0, depthM = 0.0;
    glm::dvec3 onGround{0.0};
};

Dip deepestBetween(const PathCurve& curve, const PathVertex& from, const PathVertex& to,
                   const SceneFrame& frame)
{
    Dip deepest;
    const double chord = glm::distance(from.position, to.position);
    const int samples =
        static_cast<int>(std::clamp(std::ceil(chord / kClearanceSampleM), 2.0, kMostClearanceSamples));
    for (int i = 1; i < samples; ++i)
    {
        const double parameter = from.parameter + (to.parameter - from.parameter) * i / samples;
        const glm::dvec3 at = curve.at(parameter).position;
        const auto ground = frame.groundAt(at.x, at.y, at.z);
        if (!ground || ground->heightM - at.z <= deepest.depthM) continue;
        deepest = {parameter, ground->heightM - at.z, {at.x, at.y, ground->heightM}};
    }
    return deepest;
}

Vertex vertexAt(const Dip& dip, const PathCurve& curve, const FollowTrajectoryAction& action,
                const SceneFrame& frame)
{
    const PathPoint point = curve.at(dip.parameter);
    const Geodetic place = frame.frame()->geodeticFromLocal(dip.onGround);
    GeoPosition position;
    position.latitudeDeg = place.latitudeDeg;
    position.longitudeDeg = place.longitudeDeg;
    position.heightM = place.heightM;
    if (point.pitchRad && point.rollRad)
        position.orientation = {point.headingRad, point.pitchRad, point.rollRad};
    return {{}, action.timing ? std::optional(dip.parameter) : std::nullopt, std::move(position)};
}

} // namespace

TrackClearance keepAboveGround(FollowTrajectoryAction& action, const SceneFrame& frame)
{
    TrackClearance done;
    std::vector<Vertex>& vertices = std::get<Polyline>(action.trajectory.shape).vertices;
    const double leastStep = action.timing ? kLeastStepS : kLeastStepM;
    for (int round = 0; round <= kMostLiftRounds; ++round)
    {
        const PlacedPath path = placed(action, frame);
        if (path.vertices.size() < 2) return done;
        const PathCurve curve(path.vertices, action.mode, std::nullopt);
        std::vector<Vertex> kept;
        std::size_t taken = 0; ///< of `vertices`
        done.leftM = 0.0;
        for (std::size_t i = 0; i + 1 < path.vertices.size(); ++i)
        {
            const Dip dip = deepestBetween(curve, path.vertices[i], path.vertices[i + 1], frame);
            done.deepestM = std::max(done.deepestM, dip.depthM);
            if (dip.depthM <= kAllowedM) continue;
            done.leftM = std::max(done.leftM, dip.depthM);
            if (round == kMostLiftRounds ||
                path.vertices[i + 1].parameter - path.vertices[i].parameter < 4.0 * leastStep)
                continue;
            while (taken <= path.sources[i])
                kept.push_back(vertices[taken++]);
            kept.push_back(vertexAt(dip, curve, action, frame));
            ++done.addedVertices;
        }
        if (taken == 0) return done;
        kept.insert(kept.end(), vertices.begin() + static_cast<std::ptrdiff_t>(taken), vertices.end());
        vertices = std::move(kept);
    }
    return done;
}

foundation::HeightOnEarth groundHeightOf(const SceneFrame& frame)
{
    return [&frame](double latitudeDeg, double longitudeDeg) -> std::optional<double>
    {
        constexpr int kLeanSteps =
            3; // the vertical there leans against the scene's, so place and height depend on each other
        std::optional<double> heightM = 0.0;
        for (int i = 0; i < kLeanSteps; ++i)
        {
            const glm::dvec3 at = frame.frame()->localFromGeodetic({latitudeDeg, longitudeDeg, *heightM});
            const auto ground = frame.groundAt(at.x, at.y);
            if (!ground) return std::nullopt;
            heightM = frame.frame()->geodeticFromLocal({at.x, at.y, ground->heightM}).heightM;
        }
        return heightM;
    };
}

} // namespace simulation
