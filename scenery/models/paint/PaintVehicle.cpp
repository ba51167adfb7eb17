// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintVehicle.h"

#include <vector>

#include <glm/common.hpp>

#include "scenery/models/paint/VehiclePainter.h"
#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery::models
{

namespace
{

using View = VehiclePainter::View;

/// Paints a mark once. `points`: its points, moved and mirrored.
void paintOnce(VehiclePainter& painter, const LookMark& mark, const std::vector<glm::vec2>& points)
{
    switch (mark.kind)
    {
    case LookMark::Kind::glass:
        return painter.glass(points);
    case LookMark::Kind::fill:
        return painter.fill(points, mark.colour);
    case LookMark::Kind::box:
        return painter.box(glm::min(points[0], points[1]), glm::max(points[0], points[1]), mark.cornerM,
                           mark.colour);
    case LookMark::Kind::seam:
        return painter.seam(points);
    case LookMark::Kind::plate:
        return painter.plate(points[0]);
    }
}

void paintMark(VehiclePainter& painter, const LookMark& mark, const glm::vec2& mirror)
{
    for (int i = 0; i < mark.repeats; ++i)
        for (const bool isMirrored : {false, true})
        {
            if (isMirrored && !mark.isOnBothSides) continue;
            std::vector<glm::vec2> points = mark.points;
            for (glm::vec2& point : points)
                point = (point + static_cast<float>(i) * mark.step) * (isMirrored ? mirror : glm::vec2(1.0F));
            paintOnce(painter, mark, points);
        }
}

} // namespace

Picture paintVehicle(const VehicleLook& look)
{
    VehiclePainter painter(look.form);
    const auto paint = [&](View view, LookView marks)
    {
        painter.look(view);
        // The middle line of the view from above lies along it; those of the ends are upright.
        const glm::vec2 mirror =
            view == View::front || view == View::back ? glm::vec2(-1.0F, 1.0F) : glm::vec2(1.0F, -1.0F);
        for (const LookMark& mark : look.marksOf(marks))
            paintMark(painter, mark, mirror);
    };
    paint(View::side, LookView::sides);
    paint(View::side, LookView::right);
    if (look.form.hasTwoSides)
    {
        paint(View::left, LookView::sides);
        paint(View::left, LookView::left);
    }
    paint(View::top, LookView::top);
    paint(View::front, LookView::front);
    paint(View::back, LookView::back);
    return painter.picture();
}

} // namespace scenery::models
