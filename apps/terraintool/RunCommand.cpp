// SPDX-License-Identifier: Apache-2.0
#include "terraintool/RunCommand.h"

namespace terraintool
{

int run(const Command& command, const Request& request, const std::filesystem::path& jsonFile)
{
    return terminal::report("terraintool", jsonFile, [&] { return command(request); });
}

} // namespace terraintool
