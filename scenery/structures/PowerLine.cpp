// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/PowerLine.h"

#include <algorithm>
#include <cmath>

#include "scenery/structures/Catenary.h"

namespace scenery
{

namespace
{

constexpr double kMostSpanM = 600.0,
                 kDefaultSpanM = 350.0; ///< of pylons: longer than the first, it is divided
constexpr double kMostPolesM = 160.0, kDefaultPolesM = 70.0;
constexpr double kMostRaiseM = 25.0;
constexpr double kLeastSpanM = 8.0;

std::vector<glm::dvec2> placesOf(const Structure& line)
{
    const bool isPoles = line.kind == StructureKind::poleLine;
    std::vector<glm::dvec2> places{line.line.front()};
    for (std::size_t i = 0; i + 1 < line.line.size(); ++i)
    {
        const glm::dvec2 a = places.back(), b = line.line[i + 1];
        const double lengthM = glm::distance(a, b);
        if (lengthM < kLeastSpanM && i + 2 < line.line.size()) continue;
        const int spans =
            lengthM > (isPoles ? kMostPolesM : kMostSpanM)
                ? static_cast<int>(std::ceil(lengthM / (isPoles ? kDefaultPolesM : kDefaultSpanM)))
                : 1;
        for (int span = 1; span <= spans; ++span)
            places.push_back(glm::mix(a, b, static_cast<double>(span) / spans));
    }
    return places;
}

/// By how much the lowest wire of a span comes too near to the ground.
double deficitM(const Support& a, const Support& b, const std::vector<WirePlace>& wires, double aM,
                const foundation::HeightInPlan& ground)
{
    double deficit = 0.0;
    for (const WirePlace& wire : wires)
        for (const glm::dvec3& point : catenary(wireAt(a, wire), wireAt(b, wire), aM, 24))
            if (const auto height = ground(point))
                deficit = std::max(deficit, *height + kClearanceM - point.z);
    return deficit;
}

} // namespace

const std::vector<WirePlace>& wiresOf(StructureKind kind)
{
    static const std::vector<WirePlace> pylon{{-7.0, 0.62}, {-4.0, 0.62}, {4.0, 0.62},     {7.0, 0.62},
                                              {-5.0, 0.78}, {5.0, 0.78},  {0.0, 1.0, true}};
    static const std::vector<WirePlace> pole{{-0.9, 0.96}, {0.0, 1.02}, {0.9, 0.96}};
    return kind == StructureKind::powerLine ? pylon : pole;
}

glm::dvec3 wireAt(const Support& support, const WirePlace& wire)
{
    const double wide =
        wire.isEarth || std::abs(wire.leftM) < 2.0 ? 1.0 : std::min(1.0, support.heightM / 40.0);
    return support.foot + glm::dvec3(wide * wire.leftM * glm::dvec2(-support.along.y, support.along.x),
                                     wire.share * support.heightM);
}

std::vector<Support> supportsOf(const Structure& line, const foundation::HeightInPlan& ground)
{
    const auto places = placesOf(line);
    std::vector<Support> supports;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const auto height = ground(places[i]);
        if (!height) return {};
        const glm::dvec2 before = i > 0 ? places[i] - places[i - 1] : glm::dvec2(0.0);
        const glm::dvec2 after = i + 1 < places.size() ? places[i + 1] - places[i] : glm::dvec2(0.0);
        const auto unit = [](const glm::dvec2& v) { return v / std::max(glm::length(v), 1e-9); };
        const glm::dvec2 both = unit(before) + unit(after);
        supports.push_back(
            {{places[i], *height}, glm::length(both) > 1e-6 ? unit(both) : unit(after), line.heightM});
    }
    const auto& wires = wiresOf(line.kind);
    const double aM = line.kind == StructureKind::powerLine ? kLineConstantM : kPoleConstantM;
    const double least = wires.front().share;
    for (std::size_t i = 0; i + 1 < supports.size(); ++i)
        for (int round = 0; round < 3; ++round)
        {
            const double deficit = deficitM(supports[i], supports[i + 1], wires, aM, ground);
            if (deficit <= 0.0) break;
            for (Support* support : {&supports[i], &supports[i + 1]})
                support->heightM =
                    std::min(support->heightM + 1.1 * deficit / least, line.heightM + kMostRaiseM);
        }
    return supports;
}

} // namespace scenery
