// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "compare/terrain/methods/MeasureRival.h"

namespace terraintool
{

/// One observation of a method's work in a frame.
struct WorkSample
{
    double us = 0.0, triangles = 0.0, written = 0.0;
};

/// Fits us = base + a · triangles + b · written by least squares of relative differences; coefficients below
/// zero are left out, since no work takes less than no time. Nothing: fewer than four samples, or samples
/// that do not tell them apart.
std::optional<FitFigures> fitWork(const std::vector<WorkSample>& samples);

/// Measures how the time of a method depends on the size of its mesh and on what changes: parts of the flight
/// at a quarter to four times the tolerance, and at one, two and four times the speed.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 6, which claims what
/// the time is proportional to.
std::optional<FitFigures> measureWork(const Rival& rival, const ComparedFlight& flight, double tolerancePx);

} // namespace terraintool
