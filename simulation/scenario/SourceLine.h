// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace simulation
{

/// Where in its file an element of a scenario stood; 0 for an element that no file holds.
/// Two elements that say the same are equal wherever they stand: a line never decides a comparison.
struct SourceLine
{
    int line = 0;

    bool operator==(const SourceLine&) const { return true; }
};

/// Content of the language that this version does not play: kept by name, so that a tolerant reading can go
/// on. A strict reading never produces one.
struct Unsupported
{
    SourceLine source;
    std::string element;

    bool operator==(const Unsupported&) const = default;
};

} // namespace simulation
