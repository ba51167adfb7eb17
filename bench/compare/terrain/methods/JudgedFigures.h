// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace terraintool
{

/// The range in which a statement holds, ends included.
struct HeldRange
{
    double least = 0.0, most = 0.0;
};

/// What figures say of a statement, and they themselves as text.
struct JudgedFigures
{
    std::string verdict, figure;
};

/// Confirms a statement when all its figures lie in the range, and refutes it when none does; where some do
/// it is mixed, and without a figure not measured.
/// `unit`: follows the text of the figures.
JudgedFigures judgeFigures(const std::vector<double>& figures, HeldRange holds, const std::string& unit);

} // namespace terraintool
