// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

#include "worldtool/Commands.h"

namespace worldtool
{

/// What of a world has been made, in WORLD/build.json, so that a build that was
/// ended goes on: the sum of its inputs, and of each file that is whole. A file
/// counts as made where inputs and file are as they were.
class BuildState
{
public:
    /// Reads the state of a request's world; it begins anew where the inputs are
    /// others, or it cannot be read. Errors: an input that cannot be read.
    static foundation::Result<BuildState> open(const Request& request);

    /// Tells whether a file of the world is made.
    bool has(const std::string& name) const;

    /// Tells whether the whole world is.
    bool isWhole() const;

    /// Notes that it is. Errors: build.json cannot be written.
    foundation::Outcome note(const std::string& name);

private:
    std::filesystem::path _world;
    nlohmann::ordered_json _json;
};

} // namespace worldtool
