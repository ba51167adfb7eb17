// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/terrain/methods/MethodFigures.h"

namespace terraintool
{

/// A column of a table of figures; a figure that was not measured is a dash.
struct FigureColumn
{
    const char* title;
    std::function<std::string(const MethodFigures&)> text;
};

/// The columns of the two tables of a report: the main figures, and what verdicts of advantages and drawbacks
/// need.
const std::vector<FigureColumn>& figureColumns();
const std::vector<FigureColumn>& furtherFigureColumns();

} // namespace terraintool
