// SPDX-License-Identifier: Apache-2.0
#include "PmToolRun.h"

ProgramRun runPmTool(Words arguments)
{
    arguments.insert(arguments.begin(), OSGTRAINER_PMTOOL);
    return runProgram(arguments);
}

nlohmann::ordered_json pmToolTable(const Workplace& place, Words arguments)
{
    arguments.insert(arguments.end(), {"--json", place.path("table.json")});
    EXPECT_TRUE(succeeds(runPmTool(arguments)));
    return nlohmann::ordered_json::parse(readBytes(place.path("table.json")), nullptr, false);
}

Words keysOf(const nlohmann::ordered_json& object)
{
    Words keys;
    for (const auto& [key, value] : object.items())
        keys.push_back(key);
    return keys;
}
