// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

namespace terminal
{

/// A command's table, and whether everything in it is as it must be.
struct Report
{
    nlohmann::ordered_json json;
    bool sound = true;
};

/// Does the work, writes its table to `jsonFile` unless that is empty, and returns the program's exit code:
/// kFailed after an error, and when the table says that something is not as it must be.
int report(const std::string& program, const std::filesystem::path& jsonFile,
           const std::function<foundation::Result<Report>()>& work);

} // namespace terminal
