// SPDX-License-Identifier: Apache-2.0
#include "StripTable.h"

#include <iomanip>
#include <sstream>

namespace objectbench
{

std::string stripTable(const nlohmann::ordered_json& report)
{
    std::ostringstream table;
    table << std::fixed;
    for (const auto& model : report["models"])
        for (const auto& lights : model["lights"])
        {
            const auto& finest = lights["levels"].front();
            const auto faces = finest["faces"].get<double>();
            for (const auto& [name, mean] : lights["means"].items())
            {
                const auto& drawn = finest[name];
                table << "| " << model["model"].get<std::string>() << ", " << finest["faces"] << " | "
                      << report["backend"].get<std::string>() << " | " << lights["count"] << " | " << name
                      << " | " << std::setprecision(2) << drawn["medianMs"].get<double>() << " | "
                      << drawn["p99Ms"].get<double>() << " | " << std::setprecision(3)
                      << drawn["invocations"].get<double>() / faces << " |\n";
            }
        }
    return table.str();
}

} // namespace objectbench
