// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/AreaChart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "compare/objects/ChartSvg.h"

namespace pmtool
{

namespace
{

/// A value that exceeds a tick by less than this share of the interval gets no tick of its own.
constexpr double kRounding = 0.1;

constexpr double kFewest = 0.01; // share of the faces at the left border

/// Draws one panel, with its corner at the origin.
class Panel : private ChartBox
{
public:
    explicit Panel(const AreaPanel& panel) : _panel(panel)
    {
        for (const AreaLine& line : panel.lines)
            for (const auto& [faces, area] : line.points)
            {
                if (faces < kFewest) continue;
                _low = std::min(_low, area);
                _high = std::max(_high, area);
            }
        _step = _high - _low > 0.5 ? 0.2 : _high - _low > 0.2 ? 0.1 : _high - _low > 0.08 ? 0.05 : 0.02;
        _low = std::floor(_low / _step + kRounding) * _step;
        _high = std::ceil(_high / _step - kRounding) * _step;
        if (_high - _low < 0.5 * _step) _low -= _step;
    }

    std::string svg() const
    {
        std::string out = svgLabel(kWidth / 2, 18, "middle", escaped(_panel.title), "#000000");
        for (double area = _low; area < _high + 0.5 * _step; area += _step)
            out += line(kFewest, area, 1.0, area, "#dddddd", "") +
                   svgLabel(kLeft - 4, y(area) + 3, "end", decimals(area, 2), "#000000");
        for (const double faces : {0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0})
            out += svgLabel(x(faces), kHeight - kBottom + 13, "middle", decimals(100 * faces, 0) + "%",
                            "#000000");
        out += line(0.25, _low, 0.25, _high, "#999999", " stroke-dasharray=\"3 3\"");
        for (std::size_t i = 0; i < _panel.lines.size(); ++i)
            out += curve(i);
        return out;
    }

private:
    static double x(double faces)
    {
        return kLeft + (1.0 - std::log(faces) / std::log(kFewest)) * (kWidth - kLeft - kRight);
    }
    double y(double area) const
    {
        return kTop + (_high - area) / (_high - _low) * (kHeight - kTop - kBottom);
    }

    std::string line(double fromFaces, double fromArea, double toFaces, double toArea, const char* colour,
                     const char* more) const
    {
        return svgLine(x(fromFaces), y(fromArea), x(toFaces), y(toArea), colour, more);
    }

    std::string curve(std::size_t i) const
    {
        const char* colour = kColours[std::min(i, kColours.size() - 1)];
        std::vector<std::pair<double, double>> points;
        for (const auto& [faces, area] : _panel.lines[i].points)
            if (faces >= kFewest) points.emplace_back(x(faces), y(area));
        const double at = kLeft + (0.05 + 0.24 * static_cast<double>(i)) * (kWidth - kLeft - kRight);
        return svgCurve(points, colour) +
               svgLabel(at, kHeight - 5, "start", escaped(_panel.lines[i].name), colour);
    }

    const AreaPanel& _panel;
    double _low = 1.0, _high = 1.0, _step = 0.1;
};

} // namespace

std::string areaChart(const std::vector<AreaPanel>& panels)
{
    std::vector<std::string> drawn;
    for (const AreaPanel& panel : panels)
        drawn.push_back(Panel(panel).svg());
    return svgSheet(drawn);
}

} // namespace pmtool
