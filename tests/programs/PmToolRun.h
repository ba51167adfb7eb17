// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ProgramRun.h"
#include "Workplace.h"

using Words = std::vector<std::string>;

/// Runs pmtool with these arguments.
ProgramRun runPmTool(Words arguments);

/// Runs pmtool, which must succeed, and returns the table that it wrote.
nlohmann::ordered_json pmToolTable(const Workplace& place, Words arguments);

Words keysOf(const nlohmann::ordered_json& object);
