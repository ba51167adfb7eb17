// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace measurement
{

/// One line of a plot.
struct PlotSeries
{
    std::string label;
    std::string colour;         ///< a CSS colour
    std::vector<double> values; ///< at least one for each x
};

/// A plot over a common x axis.
struct Plot
{
    std::string title;
    std::string xLabel;
    std::vector<double> x; ///< ascending
    std::vector<PlotSeries> series;
};

/// Draws a plot as an <svg> element of 720 × 220 units. The y axis begins at 0, or at the least value when
/// that is negative. More points than pixels are drawn as the least and the greatest value of each unit, so
/// that no peak is lost. A value that is infinite or no number is left out.
std::string svgPlot(const Plot& plot);

/// Returns the greatest of 1, 2, 5 times a power of ten that divides `span` into at least `steps` parts.
double niceStep(double span, int steps);

/// Escapes text for HTML and SVG: & < > ".
std::string escapedMarkup(const std::string& text);

} // namespace measurement
