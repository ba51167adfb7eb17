// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "roadtool/Pictures.h"

namespace roadtool
{

namespace
{

std::string colourText(Colour colour)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
    return text;
}

std::string pointText(glm::dvec2 point)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.2f,%.2f ", point.x, point.y);
    return text;
}

} // namespace

std::string svgText(const TopView& view, int pixels)
{
    const glm::dvec2 size = view.bounds.most - view.bounds.least;
    const double scale = pixels / std::max({size.x, size.y, 1e-3});
    char head[256];
    std::snprintf(head, sizeof head,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.2f %.2f\" width=\"%.0f\" "
                  "height=\"%.0f\">\n",
                  size.x, size.y, std::ceil(size.x * scale), std::ceil(size.y * scale));
    std::string svg = head;
    svg += "<rect width=\"100%\" height=\"100%\" fill=\"" + colourText(view.background) + "\"/>\n";
    for (const FilledPolygon& polygon : view.polygons)
    {
        svg += "<polygon fill=\"" + colourText(polygon.colour) + "\" points=\"";
        for (const glm::dvec2 corner : polygon.corners)
            svg += pointText({corner.x - view.bounds.least.x, view.bounds.most.y - corner.y});
        svg += "\"/>\n";
    }
    return svg + "</svg>\n";
}

} // namespace roadtool
