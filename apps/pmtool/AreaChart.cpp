// SPDX-License-Identifier: Apache-2.0
#include "pmtool/AreaChart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace pmtool
{

namespace
{

/// A value that exceeds a tick by less than this share of the interval gets no tick of its own.
constexpr double kRounding = 0.1;

// Pixels.
constexpr double kWidth = 420, kHeight = 240, kLeft = 48, kRight = 18, kTop = 28, kBottom = 32;
constexpr double kFewest = 0.01; // share of the faces at the left border
constexpr std::array<const char*, 4> kColours{"#1b6ca8", "#d1495b", "#2e933c", "#555555"};

/// Returns `value` with so many decimals.
std::string text(double value, int decimals)
{
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
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

/// Draws one panel, with its corner at the origin.
class Panel
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
        std::string out = label(kWidth / 2, 18, "middle", escaped(_panel.title), "#000000");
        for (double area = _low; area < _high + 0.5 * _step; area += _step)
            out += line(kFewest, area, 1.0, area, "#dddddd", "") +
                   label(kLeft - 4, y(area) + 3, "end", text(area, 2), "#000000");
        for (const double faces : {0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0})
            out += label(x(faces), kHeight - kBottom + 13, "middle", text(100 * faces, 0) + "%", "#000000");
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

    static std::string label(double x, double y, const char* anchor, const std::string& words,
                             const char* colour)
    {
        return "<text x=\"" + text(x, 1) + "\" y=\"" + text(y, 1) + "\" text-anchor=\"" + anchor +
               "\" fill=\"" + colour + "\">" + words + "</text>\n";
    }

    std::string line(double fromFaces, double fromArea, double toFaces, double toArea, const char* colour,
                     const char* more) const
    {
        return "<line x1=\"" + text(x(fromFaces), 1) + "\" y1=\"" + text(y(fromArea), 1) + "\" x2=\"" +
               text(x(toFaces), 1) + "\" y2=\"" + text(y(toArea), 1) + "\" stroke=\"" + colour + "\"" + more +
               "/>\n";
    }

    std::string curve(std::size_t i) const
    {
        const char* colour = kColours[std::min(i, kColours.size() - 1)];
        std::string out = "<polyline fill=\"none\" stroke-width=\"1.4\" stroke=\"";
        out += std::string(colour) + "\" points=\"";
        for (const auto& [faces, area] : _panel.lines[i].points)
            if (faces >= kFewest) out += text(x(faces), 1) + ',' + text(y(area), 1) + ' ';
        const double at = kLeft + (0.05 + 0.24 * static_cast<double>(i)) * (kWidth - kLeft - kRight);
        return out + "\"/>\n" + label(at, kHeight - 5, "start", escaped(_panel.lines[i].name), colour);
    }

    const AreaPanel& _panel;
    double _low = 1.0, _high = 1.0, _step = 0.1;
};

} // namespace

std::string areaChart(const std::vector<AreaPanel>& panels)
{
    const double rows = std::ceil(static_cast<double>(panels.size()) / 2.0);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + text(2 * kWidth, 0) +
                      "\" height=\"" + text(rows * kHeight, 0) +
                      "\" font-family=\"sans-serif\" font-size=\"10\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    for (std::size_t i = 0; i < panels.size(); ++i)
        out += "<g transform=\"translate(" + text(kWidth * static_cast<double>(i % 2), 0) + ' ' +
               text(kHeight * static_cast<double>(i / 2), 0) + ")\">\n" + Panel(panels[i]).svg() + "</g>\n";
    return out + "</svg>\n";
}

} // namespace pmtool
