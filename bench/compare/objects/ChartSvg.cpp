// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/ChartSvg.h"

#include <cmath>
#include <cstddef>
#include <cstdio>

namespace pmtool
{

std::string decimals(double value, int count)
{
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.*f", count, value);
    return digits;
}

std::string escaped(const std::string& plain)
{
    std::string safe;
    for (const char c : plain)
    {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else
            safe += c;
    }
    return safe;
}

std::string svgLabel(double x, double y, const char* anchor, const std::string& words, const char* colour)
{
    return "<text x=\"" + decimals(x, 1) + "\" y=\"" + decimals(y, 1) + "\" text-anchor=\"" + anchor +
           "\" fill=\"" + colour + "\">" + words + "</text>\n";
}

std::string svgLine(double fromX, double fromY, double toX, double toY, const char* colour, const char* more)
{
    return "<line x1=\"" + decimals(fromX, 1) + "\" y1=\"" + decimals(fromY, 1) + "\" x2=\"" +
           decimals(toX, 1) + "\" y2=\"" + decimals(toY, 1) + "\" stroke=\"" + colour + "\"" + more + "/>\n";
}

std::string svgCurve(const std::vector<std::pair<double, double>>& points, const char* colour)
{
    std::string out = "<polyline fill=\"none\" stroke-width=\"1.4\" stroke=\"";
    out += std::string(colour) + "\" points=\"";
    for (const auto& [x, y] : points)
        out += decimals(x, 1) + ',' + decimals(y, 1) + ' ';
    return out + "\"/>\n";
}

std::string svgSheet(const std::vector<std::string>& panels)
{
    const double rows = std::ceil(static_cast<double>(panels.size()) / 2.0);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                      decimals(2 * ChartBox::kWidth, 0) + "\" height=\"" +
                      decimals(rows * ChartBox::kHeight, 0) +
                      "\" font-family=\"sans-serif\" font-size=\"10\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    for (std::size_t i = 0; i < panels.size(); ++i)
        out += "<g transform=\"translate(" + decimals(ChartBox::kWidth * static_cast<double>(i % 2), 0) +
               ' ' + decimals(ChartBox::kHeight * static_cast<double>(i / 2), 0) + ")\">\n" + panels[i] +
               "</g>\n";
    return out + "</svg>\n";
}

} // namespace pmtool
