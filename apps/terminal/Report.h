// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

#include "terminal/Places.h"

namespace terminal
{

/// The table of a command, and whether all its checks passed.
struct Report
{
    nlohmann::ordered_json json;
    bool sound = true;
};

/// A number that is none has no form in JSON: null.
nlohmann::ordered_json numberOrNull(double value);

/// Checks the places of the command line and that of the table, does the work, writes its table to `jsonFile`
/// unless that is empty, and returns the exit code of the program: kFailed after an error, and when a check
/// of the table failed.
int report(const std::string& program, const std::filesystem::path& jsonFile,
           const std::function<foundation::Result<Report>()>& work, Places places = {});

} // namespace terminal
