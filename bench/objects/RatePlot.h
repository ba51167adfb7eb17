// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "Contestants.h"

namespace objectbench
{

/// Frames per second against faces, for each contestant, from the rows of a race that know their `faces`.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects*, 2002, figure 17.
std::string ratePlot(const std::string& model, int lights, const nlohmann::ordered_json& rows,
                     const std::vector<Contestant>& contestants);

/// Joins plots one below the other as one SVG file.
std::string plotsFile(const std::vector<std::string>& plots);

} // namespace objectbench
