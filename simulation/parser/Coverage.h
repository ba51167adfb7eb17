// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace simulation
{

/// What becomes of an element of OpenSCENARIO.
enum class Support
{
    played,       ///< in effect as the standard says
    passive,      ///< says nothing about what moves or is seen: licences, values for other programs
    approximated, ///< in effect, but not in all as the standard says
    reported,     ///< not in effect
};

/// An element of OpenSCENARIO XML 1.0 to 1.3.
struct ElementCoverage
{
    std::string_view part; ///< of the language: a heading of the page
    std::string_view name;
    Support support = Support::played;
    std::string_view instead{}; ///< what is done instead; empty where it is played
};

/// Returns every element of the standard, part by part.
std::span<const ElementCoverage> elementCoverage();

/// Returns the row of an element; null: it is none of the standard's.
const ElementCoverage* coverageOf(std::string_view element);

/// Returns the element whose name is most like a misspelt one, or nothing that is like it.
std::optional<std::string_view> likeElement(std::string_view misspelt);

/// Returns docs/reference/openscenario-coverage.md.
std::string coveragePage();

} // namespace simulation
