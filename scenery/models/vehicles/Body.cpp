// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/vehicles/Body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scenery::models
{

namespace
{

constexpr double kLeastStepM = 0.004;
constexpr std::size_t kUnderPoints = 4; ///< points of floor, wheel well and lower edge in a half section

/// Half cross sections before stretching: points from y = 0 on the floor around the outside to y = 0 on the
/// roof.
class Sections
{
public:
    explicit Sections(const StretchedForm& body) : _body(body), _form(body.form) {}

    std::vector<double> stations() const
    {
        std::vector<double> all;
        const double end = 0.5 * _form.lengthM;
        const double step = std::max(0.13, _form.lengthM / 50.0);
        for (int i = 0; i * step < _form.lengthM; ++i)
            all.push_back(i * step - end);
        for (const Curve* curve : {&_form.top, &_form.half})
            for (const Curve::Point& point : curve->points())
                all.push_back(point.at);
        const double reach = _body.archRadiusM() / _body.stretch.x;
        for (const double axle : {_form.axles.x, _form.axles.y})
        {
            std::erase_if(all, [&](double x) { return std::abs(x - axle) < 1.06 * reach; });
            for (int i = 0; i <= 14; ++i)
                all.push_back(axle - 0.995 * reach * std::cos(std::numbers::pi * i / 14));
            all.insert(all.end(), {axle - 1.01 * reach, axle + 1.01 * reach});
        }
        std::sort(all.begin(), all.end());
        std::vector<double> kept;
        for (const double x : all)
            if (kept.empty() || x - kept.back() > kLeastStepM) kept.push_back(x);
        kept.back() = end;
        return kept;
    }

    /// Returns the height of the lower edge of the sides; above the wheels that is the arch.
    double lowerEdge(double x) const
    {
        double edge = _form.bottom(x);
        for (const double axle : {_form.axles.x, _form.axles.y})
        {
            const double away = (x - axle) * _body.stretch.x;
            const double square = _body.archRadiusM() * _body.archRadiusM() - away * away;
            if (square > 0.0)
                edge = std::max(edge, (_body.wheelRadiusM() + std::sqrt(square)) / _body.stretch.z);
        }
        return edge;
    }

    std::vector<glm::dvec3> half(double x) const
    {
        const double edge = lowerEdge(x);
        const double floor = _form.bottom(x) + 0.02;
        const double wide = _form.half(x);
        const double belt = std::max(_form.belt(x), edge + 0.05);
        const double top = std::max(_form.top(x), belt + 0.01);
        const double inner = std::min(0.5 * _form.widthM - _form.wheelWidthM - 0.14, 0.8 * wide);
        std::vector<glm::dvec3> points{{x, 0.0, floor - 0.015},
                                       {x, inner, floor},
                                       {x, inner, std::max(edge, floor)},
                                       {x, sideAt(x, edge), edge}};
        for (const double share : {0.06, 0.22, 0.5, 0.8, 1.0})
        {
            const double z = glm::mix(edge, belt, share);
            points.emplace_back(x, sideAt(x, z), z);
        }
        const double rail = belt + _form.railShare * (top - belt);
        const double roofHalf = wide * (1.0 - _form.lean(x));
        for (const double share : {0.10, 0.5, 0.86})
            points.emplace_back(x, glm::mix(sideAt(x, belt), roofHalf, share), glm::mix(belt, rail, share));
        for (const double turn : {0.0, 0.22, 0.45, 0.68, 0.86, 1.0}) // a quarter of a superellipse
        {
            const double angle = 0.5 * std::numbers::pi * turn;
            points.emplace_back(
                x, roofHalf * std::pow(std::cos(angle), 2.0 / _form.roofPower) * (turn == 1.0 ? 0.0 : 1.0),
                rail + (top - rail) * std::pow(std::sin(angle), 2.0 / _form.roofPower) +
                    0.004 * turn); // so that the roof is never exactly flat
        }
        return points;
    }

private:
    /// Returns half the width at a height: narrower at the bottom, widest at a third of the height, a little
    /// less at the belt.
    double sideAt(double x, double z) const
    {
        const double bottom = _form.bottom(x);
        const double s = std::clamp((z - bottom) / (_form.belt(x) - bottom), 0.0, 1.0);
        return _form.half(x) * (1.0 - 0.055 * std::pow(1.0 - s, 4.0) - 0.035 * s * s * s);
    }

    const StretchedForm& _body;
    const VehicleForm& _form;
};

class Skin
{
public:
    Skin(ModelBuilder& builder, const StretchedForm& body)
        : _builder(builder), _sheet(body.form), _stretch(body.stretch)
    {
    }

    /// Adds a quad. `places`: its corners before stretching, counter-clockwise.
    void add(const std::array<glm::dvec3, 4>& places, bool isUnder)
    {
        const glm::dvec3 normal = glm::cross(places[2] - places[0], places[3] - places[1]);
        std::array<Corner, 4> corners;
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = {
                places[i] * _stretch,
                isUnder ? uvOf(_sheet.darkPx()) : uvOf(pixelOf(places[i], normal)),
                {},
                static_cast<float>(isUnder ? 0.6 : glm::mix(0.72, 1.0, std::min(places[i].z / 0.7, 1.0)))};
        _builder.quad(corners[0], corners[1], corners[2], corners[3]);
    }

private:
    static glm::vec2 uvOf(const glm::vec2& px) { return px / static_cast<float>(VehicleSheet::kSheetPx); }

    glm::vec2 pixelOf(const glm::dvec3& place, const glm::dvec3& normal) const
    {
        const glm::dvec3 size = glm::abs(normal);
        const glm::vec2 xy(_sheet.px(place.x), _sheet.px(place.y));
        const float z = _sheet.px(place.z);
        if (size.x > size.y && size.x > size.z)
            return (normal.x > 0.0 ? _sheet.frontOriginPx() : _sheet.backOriginPx()) + glm::vec2(xy.y, z);
        if (size.y > size.z)
            return (normal.y > 0.0 ? _sheet.leftOriginPx() : _sheet.sideOriginPx()) + glm::vec2(xy.x, z);
        return _sheet.topOriginPx() + xy;
    }

    ModelBuilder& _builder;
    VehicleSheet _sheet;
    glm::dvec3 _stretch;
};

glm::dvec3 mirrored(const glm::dvec3& p)
{
    return {p.x, -p.y, p.z};
}

} // namespace

void addBody(ModelBuilder& builder, const StretchedForm& body)
{
    const Sections sections(body);
    Skin skin(builder, body);
    std::vector<std::vector<glm::dvec3>> rings;
    for (const double x : sections.stations())
        rings.push_back(sections.half(x));
    for (std::size_t r = 0; r + 1 < rings.size(); ++r)
        for (std::size_t i = 0; i + 1 < rings[r].size(); ++i)
        {
            const auto& a = rings[r];
            const auto& b = rings[r + 1];
            const bool isUnder = i + 1 < kUnderPoints;
            skin.add({b[i], a[i], a[i + 1], b[i + 1]}, isUnder);
            skin.add({mirrored(a[i]), mirrored(b[i]), mirrored(b[i + 1]), mirrored(a[i + 1])}, isUnder);
        }
    for (std::size_t i = 0; i + 1 < rings.front().size(); ++i)
    {
        const auto& back = rings.front();
        const auto& front = rings.back();
        skin.add({mirrored(front[i]), front[i], front[i + 1], mirrored(front[i + 1])}, false);
        skin.add({back[i], mirrored(back[i]), mirrored(back[i + 1]), back[i + 1]}, false);
    }
}

} // namespace scenery::models
