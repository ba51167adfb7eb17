// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/Footing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>

namespace scenery
{

namespace
{

constexpr double kLeastArmM = 0.5; ///< over which a slope is measured

glm::dvec2 turned(glm::dvec2 place, double headingRad)
{
    const double c = std::cos(headingRad), s = std::sin(headingRad);
    return {c * place.x - s * place.y, s * place.x + c * place.y};
}

std::optional<double> heightAt(const Ground& ground, glm::dvec2 place)
{
    return ground.heightM(place);
}

/// Slopes east and north by differences, over at least kLeastArmM.
std::optional<double> slopeDegAt(const Ground& ground, glm::dvec2 place, double armM)
{
    std::array<double, 4> heights{};
    const std::array<glm::dvec2, 4> arms{{{armM, 0.0}, {-armM, 0.0}, {0.0, armM}, {0.0, -armM}}};
    for (std::size_t i = 0; i < arms.size(); ++i)
    {
        const auto height = heightAt(ground, place + arms[i]);
        if (!height) return std::nullopt;
        heights[i] = *height;
    }
    const glm::dvec2 rise(heights[0] - heights[1], heights[2] - heights[3]);
    return foundation::degreesOf(std::atan(glm::length(rise) / (2.0 * armM)));
}

std::optional<Footing> standUpright(const Ground& ground, const Measures& measures, glm::dvec2 place,
                                    double headingRad, double scale)
{
    double lowest = 1e30, highest = -1e30;
    for (const glm::dvec2& at : basePlaces(measures, scale))
    {
        const auto height = heightAt(ground, place + turned(at, headingRad));
        if (!height) return std::nullopt;
        lowest = std::min(lowest, *height);
        highest = std::max(highest, *height);
    }
    const double reach = std::max(0.0, measures.foundationM * scale - kFoundationMarginM);
    Footing footing{std::min(highest, lowest + reach), uprightAxes(headingRad), 0.0};
    if (highest - footing.heightM > kMostBuriedM * scale) return std::nullopt;
    return footing;
}

/// Least squares over the corners of a rectangle: means and differences of opposite sides.
std::optional<Footing> standTilted(const Ground& ground, const Measures& measures, glm::dvec2 place,
                                   double headingRad, double scale)
{
    const glm::dvec2 low = measures.baseLow * scale, high = measures.baseHigh * scale;
    const glm::dvec2 size = glm::max(high - low, glm::dvec2(0.1)), middle = 0.5 * (low + high);
    const std::array<glm::dvec2, 4> corners{{{high.x, high.y}, {high.x, low.y}, {low.x, high.y}, low}};
    std::array<double, 4> heights{};
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const auto height = heightAt(ground, place + turned(corners[i], headingRad));
        if (!height) return std::nullopt;
        heights[i] = *height;
    }
    const double alongX = 0.5 * (heights[0] + heights[1] - heights[2] - heights[3]) / size.x;
    const double alongY = 0.5 * (heights[0] + heights[2] - heights[1] - heights[3]) / size.y;
    double z = 0.25 * (heights[0] + heights[1] + heights[2] + heights[3]);
    double off = 0.0; // the same at all corners, but for its sign
    for (std::size_t i = 0; i < corners.size(); ++i)
        off = std::max(off, z + glm::dot(corners[i] - middle, glm::dvec2(alongX, alongY)) - heights[i]);
    if (2.0 * off > kMostSunkM * scale) return std::nullopt;
    z -= off + glm::dot(middle, glm::dvec2(alongX, alongY));
    const glm::dmat3 upright = uprightAxes(headingRad);
    const glm::dvec3 up = glm::normalize(upright * glm::dvec3(-alongX, -alongY, 1.0));
    const glm::dvec3 forward = glm::normalize(upright * glm::dvec3(1.0, 0.0, alongX));
    return Footing{z, {forward, glm::cross(up, forward), up}, 0.0};
}

} // namespace

std::vector<glm::dvec2> basePlaces(const Measures& measures, double scale)
{
    const glm::dvec2 low = measures.baseLow * scale, high = measures.baseHigh * scale, size = high - low;
    std::vector<glm::dvec2> places{0.5 * (low + high)};
    const auto side = [&](glm::dvec2 from, glm::dvec2 to)
    {
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / kRimStepM)));
        for (int i = 0; i < steps; ++i)
            places.push_back(from + (to - from) * (static_cast<double>(i) / steps));
    };
    if (size.x <= 0.0 && size.y <= 0.0) return places;
    side(low, {high.x, low.y});
    side({high.x, low.y}, high);
    side(high, {low.x, high.y});
    side({low.x, high.y}, low);
    return places;
}

std::optional<Footing> standOn(const Ground& ground, const Measures& measures, glm::dvec2 place,
                               double headingRad, double scale)
{
    auto footing = measures.stance == Stance::upright
                       ? standUpright(ground, measures, place, headingRad, scale)
                       : standTilted(ground, measures, place, headingRad, scale);
    if (!footing) return std::nullopt;
    const double arm = std::max(kLeastArmM, 0.5 * glm::length(measures.baseHigh - measures.baseLow) * scale);
    const auto slope = slopeDegAt(ground, place, arm);
    if (!slope) return std::nullopt;
    footing->slopeDeg = *slope;
    return footing;
}

} // namespace scenery
