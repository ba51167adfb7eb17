// SPDX-License-Identifier: Apache-2.0
#include "DecalMaker.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "PaintColour.h"

namespace osgRoads::core
{

namespace
{

constexpr double kShaftM = 0.20; ///< width of the shaft of an arrow

/// Where an edge of a polygon crosses u; both of its ends in the frame of the stripes.
double crossingAt(glm::dvec2 a, glm::dvec2 b, double u)
{
    return a.y + (b.y - a.y) * (u - a.x) / (b.x - a.x);
}

} // namespace

DecalMaker::DecalMaker(const PlacedNetwork& network, int road, double s, double t, double headingRad,
                       std::vector<Decal>& into)
    : _network(network),
      _road(road),
      _origin(network.surfacePoint(road, s, t)),
      _paint(paintOf(MarkColour::white)),
      _into(into)
{
    const double length = network.road(road).length, step = std::min(0.5, 0.25 * length);
    const double at = std::clamp(s, step, std::max(step, length - step));
    const glm::dvec2 along(network.surfacePoint(road, at + step, t) -
                           network.surfacePoint(road, at - step, t));
    const glm::dvec2 onRoad = glm::length(along) > 1e-9 ? glm::normalize(along) : glm::dvec2(1.0, 0.0);
    const double cosine = std::cos(headingRad), sine = std::sin(headingRad);
    _ahead = {cosine * onRoad.x - sine * onRoad.y, sine * onRoad.x + cosine * onRoad.y};
}

glm::dvec2 DecalMaker::toItem(const glm::dvec3& scene) const
{
    const glm::dvec2 to(scene - _origin);
    return {glm::dot(_ahead, to), _ahead.x * to.y - _ahead.y * to.x};
}

glm::dvec2 DecalMaker::cornerOf(const OutlineCorner& corner) const
{
    return corner.isOnRoad ? toItem(_network.surfacePoint(_road, corner.s, corner.t))
                           : glm::dvec2(corner.s, corner.t);
}

Decal DecalMaker::decal(glm::dvec2 from, glm::dvec2 along) const
{
    const glm::dvec2 left(-_ahead.y, _ahead.x);
    Decal decal;
    decal.start = _origin + glm::dvec3(_ahead * from.x + left * from.y, 0.0);
    decal.along = _ahead * along.x + left * along.y;
    decal.paint = _paint;
    return decal;
}

void DecalMaker::add(Decal decal, double length, double widthStart, double widthEnd, double shift)
{
    decal.length = length;
    decal.widthStart = widthStart;
    decal.widthEnd = widthEnd;
    decal.shift = shift;
    if (length > 1e-6 && std::max(widthStart, widthEnd) > 1e-6) _into.push_back(decal);
}

void DecalMaker::bar(glm::dvec2 from, glm::dvec2 to, double width)
{
    stripedBar(from, to, width, 0.0, 0.0);
}

void DecalMaker::stripedBar(glm::dvec2 from, glm::dvec2 to, double width, double dash, double period,
                            double phase)
{
    const double length = glm::distance(from, to);
    if (!(length > 0.0)) return;
    Decal made = decal(from, (to - from) / length);
    made.dash = dash;
    made.period = period;
    made.phase = phase;
    add(made, length, width, width, 0.0);
}

/// A head to one side, at u: long as it is seen from a driver's seat.
void DecalMaker::sideHead(int side, double u, double scale)
{
    bar({u, 0.0}, {u, side * 0.25}, 0.45 * scale);
    add(decal({u, side * 0.25}, {0.0, static_cast<double>(side)}), 0.5, 1.7 * scale, 0.0, 0.0);
}

void DecalMaker::arrow(const ArrowHeads& heads, double scale)
{
    const double foot = -2.5 * scale, neck = 0.6 * scale, tip = 2.5 * scale;
    const double side = heads.ahead ? -0.6 * scale : 1.4 * scale;
    if (heads.merge != 0)
    {
        const double aside = 0.6 * heads.merge;
        bar({foot, 0.0}, {-neck, 0.0}, kShaftM);
        add(decal({-neck, 0.0}, {1.0, 0.0}), 2.0 * neck, kShaftM, kShaftM, aside);
        add(decal({neck, aside}, {1.0, 0.0}), tip - neck, 0.75, 0.0, 0.0);
        return;
    }
    bar({foot, 0.0}, {heads.ahead ? neck : side + 0.225 * scale, 0.0}, kShaftM);
    if (heads.ahead) add(decal({neck, 0.0}, {1.0, 0.0}), tip - neck, 0.75, 0.0, 0.0);
    if (heads.left) sideHead(1, side, scale);
    if (heads.right) sideHead(-1, side, scale);
}

void DecalMaker::area(std::span<const glm::dvec2> corners, glm::dvec2 axis, double dash, double period)
{
    std::vector<glm::dvec2> turned;
    std::vector<double> cuts;
    for (const glm::dvec2& corner : corners)
    {
        turned.emplace_back(glm::dot(corner, axis), axis.x * corner.y - axis.y * corner.x);
        cuts.push_back(turned.back().x);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    {
        const double from = cuts[i], to = cuts[i + 1], middle = 0.5 * (from + to);
        if (to - from < 1e-6) continue;
        std::vector<std::pair<double, std::size_t>> crossings; // at the middle of the slab, and the edge
        for (std::size_t j = 0; j < turned.size(); ++j)
        {
            const glm::dvec2 a = turned[j], b = turned[(j + 1) % turned.size()];
            if ((a.x < middle) != (b.x < middle)) crossings.emplace_back(crossingAt(a, b, middle), j);
        }
        std::sort(crossings.begin(), crossings.end());
        const auto at = [&](std::size_t k, double u)
        {
            const std::size_t j = crossings[k].second;
            return crossingAt(turned[j], turned[(j + 1) % turned.size()], u);
        };
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        {
            const double start = 0.5 * (at(k, from) + at(k + 1, from)),
                         end = 0.5 * (at(k, to) + at(k + 1, to));
            Decal made = decal(axis * from + glm::dvec2(-axis.y, axis.x) * start, axis);
            made.dash = dash;
            made.period = period;
            made.phase = from - cuts.front();
            add(made, to - from, at(k + 1, from) - at(k, from), at(k + 1, to) - at(k, to), end - start);
        }
    }
}

} // namespace osgRoads::core
