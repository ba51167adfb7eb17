// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

#include <foundation/WholeFile.h>

namespace foundation
{

/// The folders of a path that are missing, made for a trial. The destructor removes them again.
class TrialFolders
{
public:
    explicit TrialFolders(const std::filesystem::path& folder)
    {
        std::vector<std::filesystem::path> missing;
        std::error_code ignored;
        for (auto at = folder; !at.empty() && !std::filesystem::exists(at, ignored); at = at.parent_path())
            missing.push_back(at);
        for (auto at = missing.rbegin(); at != missing.rend() && !_failed; ++at)
            if (std::filesystem::create_directory(*at, _failed)) _made.push_back(*at);
    }

    ~TrialFolders()
    {
        std::error_code ignored;
        for (auto at = _made.rbegin(); at != _made.rend(); ++at)
            std::filesystem::remove(*at, ignored);
    }

    TrialFolders(const TrialFolders&) = delete;
    TrialFolders& operator=(const TrialFolders&) = delete;

    /// Why one of them cannot be made.
    const std::error_code& failed() const { return _failed; }

private:
    std::vector<std::filesystem::path> _made;
    std::error_code _failed;
};

/// Tells whether a folder can be made, or is there, and takes the file `name`, before a long computation;
/// leaves nothing behind. An empty path stands for no folder and succeeds.
inline Outcome checkFolderWritable(const std::filesystem::path& folder, const std::filesystem::path& name)
{
    if (folder.empty()) return success();
    const TrialFolders trial(folder);
    if (trial.failed())
        return Error{folder.string(), "this folder cannot be made: " + trial.failed().message(),
                     "choose a folder that can be written to"};
    return checkWritable(folder / name);
}

} // namespace foundation
