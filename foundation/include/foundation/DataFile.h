// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <system_error>

namespace foundation
{

/// Returns the folder of the running program; empty where the system does not tell.
inline std::filesystem::path programFolder()
{
    std::error_code failed;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
    return failed ? std::filesystem::path() : program.parent_path();
}

/// Finds a file that comes with the programs, such as "vehicles/car.xml": below data/ of the working folder;
/// else where the program is installed, below share/osgtrainer/data; else below data/ of the two folders
/// above the program, as in a source tree with a build/bin. Returns "data/" and the name where it is nowhere,
/// for whoever opens it to tell.
inline std::filesystem::path dataFile(const std::filesystem::path& name)
{
    const std::filesystem::path here = "data" / name, above = programFolder().parent_path();
    std::error_code failed;
    if (std::filesystem::exists(here, failed)) return here;
    for (const std::filesystem::path& folder :
         {above / "share/osgtrainer/data", above / "data", above.parent_path() / "data"})
        if (std::filesystem::exists(folder / name, failed)) return folder / name;
    return here;
}

} // namespace foundation
