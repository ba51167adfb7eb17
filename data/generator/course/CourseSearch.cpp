// SPDX-License-Identifier: Apache-2.0
#include "CourseSearch.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "Noise.h"
#include "course/CourseProfile.h"

namespace islandgen
{

namespace
{

constexpr int kCorners = 13;
constexpr int kTries = 2500;
constexpr double kStationM = 40.0, kSmoothM = 100.0;
constexpr double kFirstRadiusM = 1150.0;
constexpr double kBesideM = 8.0; ///< where the cross slope is looked at
constexpr double kInfeasible = 1e30;

double square(double x)
{
    return x * x;
}

/// A polygon whose corners stand around a middle in steady order.
struct Polygon
{
    glm::dvec2 middle{0.0};
    double radiusM[kCorners]{};
    double turn[kCorners]{}; ///< share of the angle between corners, -0.3 … 0.3

    std::vector<glm::dvec2> corners() const
    {
        std::vector<glm::dvec2> places;
        for (int i = 0; i < kCorners; ++i)
        {
            const double angle = (i + turn[i]) * 2.0 * std::numbers::pi / kCorners;
            places.push_back(middle + radiusM[i] * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        return places;
    }
};

/// What a course costs: earthworks of 1.5 m, a grade of 4 %, a cross slope of 10 % and 250 m too few count
/// one each.
double costOf(const Terrain& terrain, const Polygon& polygon)
{
    const auto alignment = alignmentOf(polygon.corners());
    if (!alignment) return kInfeasible;
    const CourseHeights heights = courseHeights(terrain, *alignment, kStationM, kSmoothM);
    const auto line = alignment->line();
    double sum = 0.0;
    const std::size_t count = heights.roadM.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        const auto point = line.at(heights.stepM * static_cast<double>(i));
        const glm::dvec2 left =
            kBesideM * glm::dvec2(-std::sin(point.headingRad), std::cos(point.headingRad));
        const double cross =
            (groundAt(terrain, point.position + left) - groundAt(terrain, point.position - left)) /
            (2.0 * kBesideM);
        const double grade = (heights.roadM[(i + 1) % count] - heights.roadM[i]) / heights.stepM;
        sum += square((heights.roadM[i] - heights.groundM[i]) / 1.5) + square(grade / 0.04) +
               square(cross / 0.10) + (heights.groundM[i] < 4.0 ? 20.0 : 0.0);
    }
    const double shortM =
        std::max({0.0, kLeastCourseM + 250.0 - alignment->lengthM, alignment->lengthM - 8000.0});
    return sum / static_cast<double>(count) + square(shortM / 250.0);
}

} // namespace

std::optional<Alignment> searchCourse(const Terrain& terrain, const glm::dvec2& middle, std::uint64_t seed)
{
    const Noise dice(seed);
    int thrown = 0;
    const auto dieBetween = [&](double low, double high) { return low + (high - low) * dice.at(thrown++); };
    Polygon best{middle, {}, {}};
    for (int i = 0; i < kCorners; ++i)
        best.radiusM[i] = kFirstRadiusM;
    double bestCost = costOf(terrain, best);
    for (int i = 0; i < kTries; ++i)
    {
        const double reach = 1.0 - 0.95 * i / kTries;
        Polygon other = best;
        const int corner = static_cast<int>(dieBetween(0.0, kCorners)) % kCorners;
        if (dieBetween(0.0, 1.0) < 0.1)
            other.middle += 300.0 * reach * glm::dvec2(dieBetween(-1.0, 1.0), dieBetween(-1.0, 1.0));
        other.radiusM[corner] =
            std::clamp(other.radiusM[corner] + 500.0 * reach * dieBetween(-1.0, 1.0), 500.0, 1800.0);
        other.turn[corner] = std::clamp(other.turn[corner] + 0.3 * reach * dieBetween(-1.0, 1.0), -0.3, 0.3);
        const double cost = costOf(terrain, other);
        if (cost >= bestCost) continue;
        best = other;
        bestCost = cost;
    }
    return alignmentOf(best.corners());
}

} // namespace islandgen
