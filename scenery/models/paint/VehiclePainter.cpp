// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/VehiclePainter.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scenery::models
{

VehiclePainter::VehiclePainter(const VehicleForm& form)
    : _sheet(form), _canvas(VehicleSheet::kSheetPx, VehicleSheet::kSheetPx, glm::vec4(1.0F))
{
    _canvas.setFrame(_sheet.darkPx(), glm::vec2(1.0F));
    _canvas.rectangle({-40.0F, -40.0F}, {40.0F, 40.0F}, kBlack);
}

void VehiclePainter::look(View view)
{
    const glm::vec2 origin = view == View::side    ? _sheet.sideOriginPx()
                             : view == View::left  ? _sheet.leftOriginPx()
                             : view == View::top   ? _sheet.topOriginPx()
                             : view == View::front ? _sheet.frontOriginPx()
                                                   : _sheet.backOriginPx();
    _canvas.setFrame(origin, glm::vec2(_sheet.pixelsPerM));
}

void VehiclePainter::glass(const Outline& outline)
{
    _canvas.polygon(outline, kBlack);
    glm::vec2 middle(0.0F);
    float low = outline.front().y;
    float high = low;
    for (const glm::vec2& p : outline)
    {
        middle += p / static_cast<float>(outline.size());
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    Outline inner;
    for (const glm::vec2& p : outline)
        inner.push_back(p == middle ? p : p + glm::normalize(middle - p) * 0.03F);
    _canvas.polygon(inner, kGlass);
    // The reflection of the sky is painted as bands over the upper half: each is the part of the pane above a
    // horizontal line.
    constexpr int kBands = 20;
    for (int band = 1; band <= kBands; ++band)
    {
        const float from = glm::mix(low, high, 0.40F + 0.54F * static_cast<float>(band) / kBands);
        Outline upper;
        for (std::size_t i = 0; i < inner.size(); ++i)
        {
            const glm::vec2& a = inner[i];
            const glm::vec2& b = inner[(i + 1) % inner.size()];
            if (a.y >= from) upper.push_back(a);
            if ((a.y >= from) != (b.y >= from)) upper.push_back(glm::mix(a, b, (from - a.y) / (b.y - a.y)));
        }
        if (upper.size() > 2)
            _canvas.polygon(upper, glm::mix(kGlass, kSkyInGlass, static_cast<float>(band) / kBands));
    }
}

void VehiclePainter::box(const glm::vec2& low, const glm::vec2& high, float radius, const glm::vec4& colour)
{
    _canvas.rounded(low, high, radius, colour);
}

void VehiclePainter::seam(const Outline& line)
{
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        _canvas.stroke(line[i], line[i + 1], {0.011F, 0.011F}, {0.28F, 0.28F, 0.28F, 0.85F});
}

void VehiclePainter::plate(const glm::vec2& middle)
{
    box(middle - glm::vec2(0.26F, 0.055F), middle + glm::vec2(0.26F, 0.055F), 0.01F,
        {0.92F, 0.92F, 0.88F, 0.0F});
    for (int i = 0; i < 7; ++i)
    {
        const glm::vec2 at = middle + glm::vec2(-0.21F + 0.065F * static_cast<float>(i), 0.0F);
        box(at - glm::vec2(0.016F, 0.033F), at + glm::vec2(0.016F, 0.033F), 0.004F, kBlack);
    }
}

} // namespace scenery::models
