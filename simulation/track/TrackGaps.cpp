// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackGaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>
#include <glm/common.hpp>

namespace simulation
{
namespace
{

constexpr double kLongGapS = 30.0, kGapStepS = 10.0;
constexpr double kUneven = 3.0;      ///< times the neighbour
constexpr double kMostInGap = 200.0; ///< vertices
constexpr double kLeastGapStepS = 1e-3;

using Coordinates = std::array<double, 3>; ///< latitude, longitude without jumps, height

Coordinates coordinatesOf(const GeoPosition& position)
{
    return {position.latitudeDeg, position.longitudeDeg, position.heightM.value_or(0.0)};
}

/// The slope of a curve at a vertex that stays between its neighbours: the weighted harmonic mean of the
/// slopes of both chords, 0 where they differ in sign.
double boundedSlope(double beforeS, double before, double behindS, double behind)
{
    if (!(before * behind > 0.0)) return 0.0;
    const double first = 2.0 * behindS + beforeS, second = behindS + 2.0 * beforeS;
    return (first + second) / (first / before + second / behind);
}

/// The value of the cubic with these ends and slopes at a share of its width.
double cubicAt(double from, double to, double fromSlope, double toSlope, double widthS, double share)
{
    const double rest = 1.0 - share;
    return from + (to - from) * glm::smoothstep(0.0, 1.0, share) +
           widthS * share * rest * (fromSlope * rest - toSlope * share);
}

/// The times within a gap: from both ends, each step twice the one before.
std::vector<double> timesWithin(double gapS, double beforeS, double behindS)
{
    const double most = gapS > kLongGapS ? std::max(kGapStepS, gapS / kMostInGap) : gapS;
    std::vector<double> times;
    double left = 0.0, right = gapS;
    double leftStep = std::clamp(beforeS, kLeastGapStepS, most),
           rightStep = std::clamp(behindS, kLeastGapStepS, most);
    std::vector<double> fromRight;
    while (right - left > 2.0 * std::min(leftStep, rightStep))
    {
        if (leftStep <= rightStep)
        {
            times.push_back(left += leftStep);
            leftStep = std::min(2.0 * leftStep, most);
        }
        else
        {
            fromRight.push_back(right -= rightStep);
            rightStep = std::min(2.0 * rightStep, most);
        }
    }
    if (gapS > kLongGapS && right - left > 1.5 * most) times.push_back(0.5 * (left + right));
    times.insert(times.end(), fromRight.rbegin(), fromRight.rend());
    return times;
}

std::optional<double> angleBetween(const std::optional<double>& from, const std::optional<double>& to,
                                   double share)
{
    if (!from || !to) return std::nullopt;
    return *from + share * foundation::wrappedRad(*to - *from);
}

/// Fills gaps of one list of vertices.
class GapFiller
{
public:
    explicit GapFiller(const std::vector<Vertex>& vertices) : _vertices(vertices)
    {
        for (const Vertex& vertex : vertices)
        {
            _places.push_back(coordinatesOf(std::get<GeoPosition>(vertex.position)));
            if (_places.size() < 2) continue;
            const double before = _places[_places.size() - 2][1];
            _places.back()[1] = before + foundation::wrappedDeg(_places.back()[1] - before);
        }
    }

    std::vector<Vertex> filled() const
    {
        std::vector<Vertex> result;
        for (std::size_t i = 0; i < _vertices.size(); ++i)
        {
            result.push_back(_vertices[i]);
            if (i + 1 == _vertices.size()) break;
            const double gapS = gap(i);
            const double beforeS = i > 0 ? gap(i - 1) : gapS;
            const double behindS = i + 2 < _vertices.size() ? gap(i + 1) : gapS;
            if (gapS <= kLongGapS && gapS <= kUneven * std::min(beforeS, behindS)) continue;
            for (const double timeS : timesWithin(gapS, beforeS, behindS))
                result.push_back(between(i, timeS / gapS));
        }
        return result;
    }

private:
    double gap(std::size_t i) const { return *_vertices[i + 1].timeS - *_vertices[i].timeS; }

    double chord(std::size_t i, std::size_t axis) const
    {
        return (_places[i + 1][axis] - _places[i][axis]) / gap(i);
    }

    double slope(std::size_t i, std::size_t axis) const
    {
        if (i == 0) return chord(0, axis);
        if (i + 1 == _places.size()) return chord(i - 1, axis);
        return boundedSlope(gap(i - 1), chord(i - 1, axis), gap(i), chord(i, axis));
    }

    Vertex between(std::size_t i, double share) const
    {
        const auto& from = std::get<GeoPosition>(_vertices[i].position);
        const auto& to = std::get<GeoPosition>(_vertices[i + 1].position);
        const double gapS = gap(i);
        Coordinates place{};
        for (std::size_t axis = 0; axis < place.size(); ++axis)
            place[axis] = gapS > kLongGapS
                              ? _places[i][axis] + share * (_places[i + 1][axis] - _places[i][axis])
                              : cubicAt(_places[i][axis], _places[i + 1][axis], slope(i, axis),
                                        slope(i + 1, axis), gapS, share);
        GeoPosition position = share < 0.5 ? from : to;
        position.latitudeDeg = place[0];
        position.longitudeDeg = foundation::wrappedDeg(place[1]);
        if (from.heightM && to.heightM) position.heightM = place[2];
        Orientation& pose = position.orientation;
        pose.headingRad = angleBetween(from.orientation.headingRad, to.orientation.headingRad, share);
        pose.pitchRad = angleBetween(from.orientation.pitchRad, to.orientation.pitchRad, share);
        pose.rollRad = angleBetween(from.orientation.rollRad, to.orientation.rollRad, share);
        return {_vertices[i].source, *_vertices[i].timeS + share * gapS, std::move(position)};
    }

    const std::vector<Vertex>& _vertices;
    std::vector<Coordinates> _places;
};

} // namespace

void fillGaps(std::vector<Vertex>& vertices)
{
    if (vertices.size() > 1) vertices = GapFiller(vertices).filled();
}

std::optional<std::string> gapsOf(const FlightTrack& track)
{
    constexpr double kTimesDefault = 5.0;
    if (!track.hasTimes || track.fixes.size() < 3) return std::nullopt;
    std::vector<double> gaps;
    for (std::size_t i = 1; i < track.fixes.size(); ++i)
        gaps.push_back(track.fixes[i].timeS - track.fixes[i - 1].timeS);
    std::vector<double> sorted = gaps;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double longS = std::max(kLongGapS, kTimesDefault * *middle);
    const auto count = std::count_if(gaps.begin(), gaps.end(), [&](double gapS) { return gapS > longS; });
    if (count == 0) return std::nullopt;
    const auto longest = std::max_element(gaps.begin(), gaps.end());
    char text[160];
    std::snprintf(
        text, sizeof text,
        "no fix for more than %.0f s %ld times, for %.0f s after line %d; the way is straight there", longS,
        static_cast<long>(count), *longest,
        track.fixes[static_cast<std::size_t>(longest - gaps.begin())].line);
    return text;
}

} // namespace simulation
