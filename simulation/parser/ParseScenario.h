// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

#include "simulation/scenario/Scenario.h"

namespace simulation
{

struct ParseOptions
{
    /// Collect what is not supported or wrong in the content as problems, and go on, instead of ending with
    /// the first. Text that is not XML, or not OpenSCENARIO, is an Error all the same.
    bool tolerant = false;

    /// Values that replace the file's own for its top-level parameters.
    std::map<std::string, std::string> parameters;

    std::size_t maximumBytes = std::size_t{64} << 20; ///< of each file read
};

/// One thing found in a file.
struct Problem
{
    enum class Kind
    {
        unsupported, ///< part of the language (or of someone's extension), but not of this version
        invalid,     ///< against the language: a missing attribute, a bad number, an unknown entity
    };

    Kind kind = Kind::invalid;
    foundation::Error error;
};

struct ParsedScenario
{
    Scenario scenario;
    std::vector<Problem> problems; ///< empty after a strict reading; at most 1000, in the order found
};

/// Reads an OpenSCENARIO XML file, 1.0 to 1.3, with the catalogues it names (relative to its folder; only
/// folders and regular files are opened). What the model has room for is understood, the rest is a problem by
/// name. Errors, each as `file:line`: not readable, larger than the limit, not XML, nested deeper than 64
/// elements, not a scenario; strict also every problem. Parameters: `$name` and `${expression}` are replaced
/// while reading; a declaration sees only those before it, so nothing can refer to itself.
foundation::Result<ParsedScenario> readScenario(const std::filesystem::path& file,
                                                const ParseOptions& options = {});

/// The same from memory; `name` stands for the file in messages. There are no catalogues: the text has no
/// folder.
foundation::Result<ParsedScenario> parseScenario(std::string_view text, const std::string& name,
                                                 const ParseOptions& options = {});

} // namespace simulation
