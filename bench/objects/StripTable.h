// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace objectbench
{

/// The finest levels of a report of object_frame_bench as Markdown: a row for each model and way to draw it.
/// Without the head of the table, so that reports can follow one another.
std::string stripTable(const nlohmann::ordered_json& report);

} // namespace objectbench
