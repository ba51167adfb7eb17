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
    std::string colour;         ///< as CSS says it
    std::vector<double> values; ///< one per x; at least as many as there are x
};

/// A plot over a common x axis.
struct Plot
{
    std::string title;
    std::string xLabel;
    std::vector<double> x; ///< ascending
    std::vector<PlotSeries> series;
};

/// The plot as an <svg> element of 720 × 220 units, the y axis from 0 (or the least value, where that is below 0).
/// More points than fit are drawn as the least and greatest of each unit, so that no peak is lost.
std::string svgPlot(const Plot& plot);

/// The greatest of 1, 2, 5 times a power of ten that divides `span` into at least `steps` parts.
double niceStep(double span, int steps);

/// Text for HTML and SVG: & < > " replaced.
std::string escapedMarkup(const std::string& text);

} // namespace measurement
