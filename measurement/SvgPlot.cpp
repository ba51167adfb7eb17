// SPDX-License-Identifier: Apache-2.0
#include "measurement/SvgPlot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace measurement
{

namespace
{

constexpr double kWidth = 720.0;
constexpr double kHeight = 220.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 12.0;
constexpr double kTop = 28.0;
constexpr double kBottom = 34.0;

std::string formatted(const char* pattern, double value)
{
    char text[48];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

/// From values to places in the picture.
struct Axes
{
    double x0, x1, y0, y1;

    double px(double x) const { return kLeft + (x - x0) / (x1 - x0) * (kWidth - kLeft - kRight); }
    double py(double y) const
    {
        return kHeight - kBottom - (y - y0) / (y1 - y0) * (kHeight - kTop - kBottom);
    }
};

Axes axesOf(const Plot& plot)
{
    Axes axes{plot.x.empty() ? 0.0 : plot.x.front(), plot.x.empty() ? 1.0 : plot.x.back(), 0.0, 0.0};
    for (const PlotSeries& series : plot.series)
    {
        for (const double value : series.values)
        {
            if (!std::isfinite(value)) continue;
            axes.y0 = std::min(axes.y0, value);
            axes.y1 = std::max(axes.y1, value);
        }
    }
    if (axes.x1 <= axes.x0) axes.x1 = axes.x0 + 1.0;
    if (axes.y1 <= axes.y0) axes.y1 = axes.y0 + 1.0;
    axes.y1 += 0.05 * (axes.y1 - axes.y0);
    return axes;
}

std::string textAt(double x, double y, const char* anchor, const std::string& text)
{
    return "<text x=\"" + formatted("%.1f", x) + "\" y=\"" + formatted("%.1f", y) + "\" text-anchor=\"" +
           anchor + "\">" + escapedMarkup(text) + "</text>";
}

std::string gridLine(double x1, double y1, double x2, double y2)
{
    return "<line x1=\"" + formatted("%.1f", x1) + "\" y1=\"" + formatted("%.1f", y1) + "\" x2=\"" +
           formatted("%.1f", x2) + "\" y2=\"" + formatted("%.1f", y2) + "\" class=\"grid\"/>";
}

/// Multiples of a nice step within [from, to].
std::vector<double> ticks(double from, double to, int wanted)
{
    const double step = niceStep(to - from, wanted);
    const auto first = static_cast<long>(std::ceil(from / step)),
               last = static_cast<long>(std::floor(to / step));
    std::vector<double> places;
    for (long i = first; i <= last; ++i)
        places.push_back(static_cast<double>(i) * step);
    return places;
}

std::string grid(const Axes& axes)
{
    std::string svg;
    for (const double y : ticks(axes.y0, axes.y1, 4))
    {
        svg += gridLine(kLeft, axes.py(y), kWidth - kRight, axes.py(y));
        svg += textAt(kLeft - 6.0, axes.py(y) + 4.0, "end", formatted("%.6g", y));
    }
    for (const double x : ticks(axes.x0, axes.x1, 6))
    {
        svg += gridLine(axes.px(x), kTop, axes.px(x), kHeight - kBottom);
        svg += textAt(axes.px(x), kHeight - kBottom + 15.0, "middle", formatted("%.6g", x));
    }
    return svg;
}

std::string pointAt(double x, double y)
{
    return formatted("%.1f", x) + "," + formatted("%.1f", y) + " ";
}

std::string lineOf(const Plot& plot, const PlotSeries& series, const Axes& axes)
{
    std::string points;
    const std::size_t count = std::min(plot.x.size(), series.values.size());
    for (std::size_t i = 0; i < count;)
    {
        // All values that fall on one unit of width.
        const double column = std::floor(axes.px(plot.x[i]));
        double least = std::numeric_limits<double>::infinity(), greatest = -least;
        const std::size_t first = i;
        for (; i < count && std::floor(axes.px(plot.x[i])) == column; ++i)
        {
            if (!std::isfinite(series.values[i])) continue;
            least = std::min(least, series.values[i]);
            greatest = std::max(greatest, series.values[i]);
        }
        if (least > greatest) continue;
        points += pointAt(axes.px(plot.x[first]), axes.py(greatest));
        if (least < greatest) points += pointAt(axes.px(plot.x[first]), axes.py(least));
    }
    return "<polyline fill=\"none\" stroke=\"" + escapedMarkup(series.colour) + "\" points=\"" + points +
           "\"/>";
}

} // namespace

double niceStep(double span, int steps)
{
    const double most = span / steps;
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= most) return factor * power;
    return power;
}

std::string escapedMarkup(const std::string& text)
{
    std::string escaped;
    for (const char c : text)
    {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '"')
            escaped += "&quot;";
        else
            escaped += c;
    }
    return escaped;
}

std::string svgPlot(const Plot& plot)
{
    const Axes axes = axesOf(plot);
    std::string svg =
        "<svg viewBox=\"0 0 720 220\" role=\"img\" aria-label=\"" + escapedMarkup(plot.title) + "\">\n";
    svg += grid(axes);
    svg += textAt(kWidth - kRight, kHeight - 4.0, "end", plot.xLabel);
    double legendX = kWidth - kRight;
    for (auto series = plot.series.rbegin(); series != plot.series.rend(); ++series)
    {
        svg += "\n" + lineOf(plot, *series, axes);
        svg += "<g fill=\"" + escapedMarkup(series->colour) + "\">" +
               textAt(legendX, 16.0, "end", series->label) + "</g>";
        legendX -= 7.5 * static_cast<double>(series->label.size()) + 14.0;
    }
    return svg + "\n" + textAt(kLeft, 16.0, "start", plot.title) + "\n</svg>\n";
}

} // namespace measurement
