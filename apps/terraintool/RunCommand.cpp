// SPDX-License-Identifier: Apache-2.0
#include "terraintool/RunCommand.h"

#include <viewlod/WholeFile.h>

#include "terminal/Terminal.h"

namespace terraintool
{

namespace
{

/// A file's name may hold any bytes; JSON holds UTF-8.
std::string textOf(const nlohmann::ordered_json& json)
{
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace

int run(const Command& command, const Request& request, const std::filesystem::path& jsonFile)
{
    if (const auto writable = viewlod::checkWritable(jsonFile); !writable)
        return terminal::fail("terraintool", writable.error());
    const auto report = command(request);
    if (!report) return terminal::fail("terraintool", report.error());
    if (!jsonFile.empty())
        if (const auto written = viewlod::writeWholeFile(jsonFile, textOf(report->json)); !written)
            return terminal::fail("terraintool", written.error());
    return report->sound ? terminal::kDone : terminal::kFailed;
}

} // namespace terraintool
