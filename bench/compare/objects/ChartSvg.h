// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace pmtool
{

/// The box of a chart within its panel, and the colours of its lines. Units: pixels.
struct ChartBox
{
    static constexpr double kWidth = 420, kHeight = 240, kLeft = 48, kRight = 18, kTop = 28, kBottom = 32;
    static constexpr std::array<const char*, 4> kColours{"#1b6ca8", "#d1495b", "#2e933c", "#555555"};
};

/// Returns `value` with so many decimals.
std::string decimals(double value, int count);

/// Returns text for SVG, with its special characters escaped.
std::string escaped(const std::string& plain);

/// Return SVG elements. `anchor`: start, middle or end; `more`: further attributes, with a space before.
std::string svgLabel(double x, double y, const char* anchor, const std::string& words, const char* colour);
std::string svgLine(double fromX, double fromY, double toX, double toY, const char* colour,
                    const char* more = "");
std::string svgCurve(const std::vector<std::pair<double, double>>& points, const char* colour);

/// Returns one SVG image of panels, two in a row.
std::string svgSheet(const std::vector<std::string>& panels);

} // namespace pmtool
