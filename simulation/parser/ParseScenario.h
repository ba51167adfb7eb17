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
    /// True: unsupported and wrong content is collected as problems and reading goes on. False: reading ends
    /// at the first. Text that is not XML or not OpenSCENARIO is an Error in both cases.
    bool tolerant = false;

    /// Values that replace those of the file for its top-level parameters.
    std::map<std::string, std::string> parameters;

    std::size_t maximumBytes = std::size_t{64} << 20; ///< of each file read
};

/// A problem found in a file.
struct Problem
{
    enum class Kind
    {
        approximated, ///< in effect, but not in all as the standard says
        unsupported,  ///< part of the standard, but not in effect
        unknown,      ///< no part of the standard: a misspelt element, or one of another program
        assumed,      ///< against the standard, but with one plain reading, which is taken
        invalid,      ///< against the standard: a missing attribute, a bad number, an unknown entity
    };

    Kind kind = Kind::invalid;
    foundation::Error error;
};

struct ParsedScenario
{
    Scenario scenario;
    std::vector<Problem> problems; ///< empty after a strict reading; at most 1000, by file and line
    std::map<std::string, int>
        elements; ///< how many of each there are, without what stands in those not in effect
};

/// Reads an OpenSCENARIO XML file, 1.0 to 1.3, and the catalogues that it names relative to its folder; only
/// folders and regular files are opened. Content that the model cannot hold becomes a problem with the name
/// of the element.
/// Parameters: `$name` and `${expression}` are replaced while reading; a declaration sees those before it, so
/// there are no cycles. Errors, each as `file:line`: not readable, larger than the limit, not XML, more than
/// 64 nested elements, not a scenario; a strict reading also returns the first problem.
foundation::Result<ParsedScenario> readScenario(const std::filesystem::path& file,
                                                const ParseOptions& options = {});

/// Reads a scenario from memory, without catalogues. `name` replaces the file in messages.
foundation::Result<ParsedScenario> parseScenario(std::string_view text, const std::string& name,
                                                 const ParseOptions& options = {});

} // namespace simulation
