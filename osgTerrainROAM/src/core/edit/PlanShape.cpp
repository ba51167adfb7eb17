// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <foundation/NearestOnSegment.h>

#include <osgTerrainROAM/core/edit/PlanShape.h>

namespace osgTerrainROAM::core
{

namespace
{

PlanBox boxAround(const glm::dvec2& a, const glm::dvec2& b)
{
    return {glm::min(a, b), glm::max(a, b)};
}

} // namespace

Region Region::circle(const glm::dvec2& centre, double radiusM)
{
    Region region;
    region._centre = centre;
    region._radiusM = radiusM;
    return region;
}

Region Region::polygon(std::vector<glm::dvec2> corners)
{
    Region region;
    region._corners = std::move(corners);
    return region;
}

double Region::insideM(const glm::dvec2& place) const
{
    if (_corners.empty()) return _radiusM - glm::distance(place, _centre);
    double distanceM = std::numeric_limits<double>::infinity();
    bool isInside = false;
    for (std::size_t i = 0, j = _corners.size() - 1; i < _corners.size(); j = i++)
    {
        const glm::dvec2 &a = _corners[j], &b = _corners[i];
        distanceM =
            std::min(distanceM, glm::distance(place, glm::mix(a, b, foundation::nearestShare(place, a, b))));
        const bool crosses =
            (a.y > place.y) != (b.y > place.y) && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y);
        isInside = isInside != crosses;
    }
    return isInside ? distanceM : -distanceM;
}

PlanBox Region::box() const
{
    if (_corners.empty()) return PlanBox{_centre, _centre}.grownBy(_radiusM);
    PlanBox box{_corners.front(), _corners.front()};
    for (const glm::dvec2& corner : _corners)
        box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    return box;
}

PlanLine::PlanLine(std::vector<glm::dvec2> points) : _points(std::move(points))
{
    const auto wayOn = [this](std::size_t i) // from point i to the next
    {
        const glm::dvec2 way = _points[i + 1] - _points[i];
        const double lengthM = glm::length(way);
        return lengthM > 0.0 ? way / lengthM : glm::dvec2(0.0);
    };
    _alongM.push_back(0.0);
    for (std::size_t i = 0; i < _points.size(); ++i)
    {
        if (i > 0) _alongM.push_back(_alongM.back() + glm::distance(_points[i - 1], _points[i]));
        const glm::dvec2 before = i > 0 ? wayOn(i - 1) : glm::dvec2(0.0);
        const glm::dvec2 behind = i + 1 < _points.size() ? wayOn(i) : glm::dvec2(0.0);
        const glm::dvec2 both = before + behind;
        _ways.push_back(glm::length(both) > 1e-6 ? glm::normalize(both) : behind);
    }
}

PlanLine::Foot PlanLine::footOf(const glm::dvec2& place) const
{
    Foot nearest{0.0, std::numeric_limits<double>::infinity()};
    std::size_t stretch = 0;
    for (std::size_t i = 1; i < _points.size(); ++i)
    {
        const double share = foundation::nearestShare(place, _points[i - 1], _points[i]);
        const double distanceM = glm::distance(place, glm::mix(_points[i - 1], _points[i], share));
        if (distanceM >= nearest.distanceM) continue;
        nearest = {std::lerp(_alongM[i - 1], _alongM[i], share), distanceM};
        stretch = i;
    }
    if (stretch == 0) return nearest;
    const double pastM = glm::dot(place - _points[stretch - 1], _ways[stretch - 1]);
    const double aheadM = glm::dot(_points[stretch] - place, _ways[stretch]);
    const double share = std::clamp(pastM / std::max(pastM + aheadM, 1e-9), 0.0, 1.0);
    nearest.alongM = std::lerp(_alongM[stretch - 1], _alongM[stretch], share);
    return nearest;
}

glm::dvec2 PlanLine::at(double alongM) const
{
    const auto next = std::upper_bound(_alongM.begin() + 1, _alongM.end() - 1, alongM);
    const auto i = static_cast<std::size_t>(next - _alongM.begin());
    const double lengthM = _alongM[i] - _alongM[i - 1];
    const double share = lengthM > 0.0 ? std::clamp((alongM - _alongM[i - 1]) / lengthM, 0.0, 1.0) : 0.0;
    return glm::mix(_points[i - 1], _points[i], share);
}

std::vector<PlanBox> PlanLine::boxes(double reachM) const
{
    const double pieceM = std::max(2.0 * reachM, 1.0);
    std::vector<PlanBox> boxes;
    for (std::size_t i = 1; i < _points.size(); ++i)
    {
        const double lengthM = _alongM[i] - _alongM[i - 1];
        const int pieces = std::max(static_cast<int>(std::ceil(lengthM / pieceM)), 1);
        for (int k = 0; k < pieces; ++k)
        {
            const auto place = [&](int n)
            { return glm::mix(_points[i - 1], _points[i], static_cast<double>(n) / pieces); };
            boxes.push_back(boxAround(place(k), place(k + 1)).grownBy(reachM));
        }
    }
    return boxes;
}

} // namespace osgTerrainROAM::core
