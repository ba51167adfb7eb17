// SPDX-License-Identifier: Apache-2.0
#include "terminal/Report.h"

#include <cmath>

#include <foundation/WholeFile.h>

#include "terminal/Terminal.h"

namespace terminal
{

namespace
{

/// A file's name may hold any bytes; JSON holds UTF-8.
std::string textOf(const nlohmann::ordered_json& json)
{
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace

nlohmann::ordered_json numberOrNull(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
}

int report(const std::string& program, const std::filesystem::path& jsonFile,
           const std::function<foundation::Result<Report>()>& work, Places places)
{
    places.written.push_back(jsonFile);
    if (const auto usable = checkPlaces(places); !usable) return fail(program, usable.error());
    const auto done = work();
    if (!done) return fail(program, done.error());
    if (!jsonFile.empty())
        if (const auto written = foundation::writeWholeFile(jsonFile, textOf(done->json)); !written)
            return fail(program, written.error());
    return done->sound ? kDone : kFailed;
}

} // namespace terminal
