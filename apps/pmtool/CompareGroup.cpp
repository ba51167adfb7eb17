// SPDX-License-Identifier: Apache-2.0
#include "pmtool/Commands.h"

namespace pmtool
{

CLI::App* addCompareGroup(CLI::App& app)
{
    CLI::App* group = app.add_subcommand("compare", "measure several algorithms side by side");
    group->require_subcommand(1);
    return group;
}

} // namespace pmtool
