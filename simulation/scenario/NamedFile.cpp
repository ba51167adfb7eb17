// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/NamedFile.h"

#include <algorithm>
#include <system_error>

namespace simulation
{

std::filesystem::path namedFile(const std::filesystem::path& folder, std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path path(name);
    std::error_code ignored;
    for (const auto& candidate : {folder / path, folder / path.filename(), path})
        if (!candidate.filename().empty() && std::filesystem::exists(candidate, ignored)) return candidate;
    return folder / path;
}

} // namespace simulation
