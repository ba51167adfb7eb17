// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace simulation
{

/// The line of an element in its file; 0 for an element without a file. Lines never decide a comparison:
/// elements with the same content are equal.
struct SourceLine
{
    int line = 0;

    bool operator==(const SourceLine&) const { return true; }
};

/// Content of the standard that is not played. It is kept by name, so that a tolerant reading can go on; a
/// strict reading never makes one.
struct Unsupported
{
    SourceLine source;
    std::string element;

    bool operator==(const Unsupported&) const = default;
};

} // namespace simulation
