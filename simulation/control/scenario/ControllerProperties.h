// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include "simulation/scenario/Entity.h"

namespace simulation
{

/// Reads the properties of a controller with physics, and keeps the first error; what is read after an error
/// is the fallback.
class ControllerProperties
{
public:
    /// `folder`: of the scenario, to which paths are relative. `names`: all that there may be.
    ControllerProperties(const Controller& controller, std::filesystem::path folder,
                         const std::vector<std::string_view>& names);

    const std::optional<foundation::Error>& error() const { return _error; }

    std::string text(std::string_view name, const std::string& fallback = {}) const;

    /// A number from `least` to `most`.
    double number(std::string_view name, double fallback, double least, double most);

    /// Numbers parted by commas, from `least` to `most` of them; none where the property is not there.
    std::vector<double> numbers(std::string_view name, std::size_t least, std::size_t most);

    bool flag(std::string_view name, bool fallback);

    /// A file: beside the scenario, else from where the program runs. `fallback`: as it stands, from where
    /// the program runs.
    std::filesystem::path file(std::string_view name, const std::filesystem::path& fallback);

private:
    void fail(std::string_view name, const std::string& what, const std::string& remedy);

    const Controller& _controller;
    std::filesystem::path _folder;
    std::optional<foundation::Error> _error;
};

} // namespace simulation
