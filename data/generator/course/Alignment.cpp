// SPDX-License-Identifier: Apache-2.0
#include "Alignment.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace islandgen
{

namespace
{

using osgRoads::core::ArcShape;
using osgRoads::core::Clothoid;
using osgRoads::core::LineShape;
using osgRoads::core::PlanElement;

constexpr double kLeastTurnRad = 0.05, kMostTurnRad = 2.1;
constexpr double kLeastSpiralM = 20.0, kLongestSpiralM = 80.0;

/// A corner of the polygon with the bend that rounds it.
struct Corner
{
    double turnRad = 0.0; ///< positive to the left
    double radiusM = 0.0, spiralM = 0.0;
    double tangentM = 0.0; ///< from the corner back to the start of the bend
};

/// A third of the radius, but not so long that the two spirals take more than 60 % of the turn.
double spiralFor(double radiusM, double turnRad)
{
    return std::min(std::clamp(radiusM / 3.0, kLeastSpiralM, kLongestSpiralM), 0.6 * turnRad * radiusM);
}

double tangentOf(double radiusM, double spiralM, double turnRad)
{
    const auto end = Clothoid(0.0, 1.0 / radiusM, spiralM).at(spiralM);
    const double shift = end.position.y - radiusM * (1.0 - std::cos(end.headingRad));
    const double along = end.position.x - radiusM * std::sin(end.headingRad);
    return (radiusM + shift) * std::tan(0.5 * turnRad) + along;
}

/// Chooses the largest radius whose tangents are not longer than `roomM`.
std::optional<Corner> cornerWithin(double turnRad, double roomM)
{
    const double turn = std::abs(turnRad);
    if (turn < kLeastTurnRad || turn > kMostTurnRad) return std::nullopt;
    const auto tangent = [turn](double radiusM)
    { return tangentOf(radiusM, spiralFor(radiusM, turn), turn); };
    double low = kLeastRadiusM, high = kLargestRadiusM;
    if (tangent(low) > roomM) return std::nullopt;
    if (tangent(high) <= roomM)
        low = high;
    else
        for (int i = 0; i < 12; ++i)
        {
            const double middle = 0.5 * (low + high);
            (tangent(middle) <= roomM ? low : high) = middle;
        }
    const double radiusM = std::floor(low);
    return Corner{turnRad, radiusM, spiralFor(radiusM, turn), tangent(radiusM)};
}

double turnBetween(const glm::dvec2& before, const glm::dvec2& after)
{
    return std::atan2(before.x * after.y - before.y * after.x, glm::dot(before, after));
}

/// Puts elements one behind the other.
class Chain
{
public:
    Chain(Alignment& alignment, const glm::dvec2& place, double headingRad)
        : _alignment(alignment), _place(place), _headingRad(headingRad)
    {
    }

    void add(double lengthM, PlanElement::Shape shape)
    {
        PlanElement& element = _alignment.elements.emplace_back(_alignment.lengthM, lengthM, _place,
                                                                _headingRad, std::move(shape));
        const auto end = element.at(lengthM);
        _place = end.position;
        _headingRad = end.headingRad;
        _alignment.lengthM += lengthM;
    }

    void addBend(const Corner& corner)
    {
        const double curvature = std::copysign(1.0 / corner.radiusM, corner.turnRad);
        Bend bend{_alignment.lengthM, 0.0, corner.spiralM, corner.radiusM, corner.turnRad > 0.0};
        add(corner.spiralM, Clothoid(0.0, curvature, corner.spiralM));
        add(std::abs(corner.turnRad) * corner.radiusM - corner.spiralM, ArcShape{curvature});
        add(corner.spiralM, Clothoid(curvature, 0.0, corner.spiralM));
        bend.endM = _alignment.lengthM;
        _alignment.bends.push_back(bend);
    }

private:
    Alignment& _alignment;
    glm::dvec2 _place;
    double _headingRad;
};

} // namespace

std::optional<Alignment> alignmentOf(const std::vector<glm::dvec2>& corners)
{
    const std::size_t count = corners.size();
    std::vector<glm::dvec2> edges(count); // edge i leads to corner i
    for (std::size_t i = 0; i < count; ++i)
        edges[i] = corners[i] - corners[(i + count - 1) % count];
    std::vector<Corner> bends;
    for (std::size_t i = 0; i < count; ++i)
    {
        const glm::dvec2& after = edges[(i + 1) % count];
        const double roomM = 0.5 * (std::min(glm::length(edges[i]), glm::length(after)) - kLeastStraightM);
        const auto bend = cornerWithin(turnBetween(edges[i], after), roomM);
        if (!bend) return std::nullopt;
        bends.push_back(*bend);
    }
    Alignment alignment;
    const glm::dvec2 way = glm::normalize(edges[0]);
    Chain chain(alignment, corners[count - 1] + bends[count - 1].tangentM * way, std::atan2(way.y, way.x));
    for (std::size_t i = 0; i < count; ++i)
    {
        const double tangentsM = bends[(i + count - 1) % count].tangentM + bends[i].tangentM;
        chain.add(glm::length(edges[i]) - tangentsM, LineShape{});
        chain.addBend(bends[i]);
    }
    return alignment;
}

} // namespace islandgen
