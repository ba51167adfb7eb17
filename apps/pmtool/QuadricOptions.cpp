// SPDX-License-Identifier: Apache-2.0
#include "pmtool/QuadricOptions.h"

#include <map>
#include <string>

#include "terminal/CommandLine.h"

namespace pmtool
{

void addQuadrics(CLI::App& command, osgPMObjects::core::Quadrics& quadrics)
{
    using osgPMObjects::core::Quadrics;
    const std::map<std::string, Quadrics> all = {{"memoryless", Quadrics::memoryless},
                                                 {"accumulated", Quadrics::accumulated}};
    command
        .add_option("--quadrics", quadrics,
                    "planes that a collapse is judged by: memoryless: of the faces as they are (default); "
                    "accumulated: "
                    "of all that were ever there")
        ->transform(terminal::named(all));
}

} // namespace pmtool
