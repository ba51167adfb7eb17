// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace simulation
{

/// How a reading ended.
enum class ReadEnd
{
    complete,
    late,   ///< the time is over
    closed, ///< nobody writes any more
    tooLong ///< a mebibyte without an end
};

/// Reads pieces of text from a pipe or a socket, and never waits longer than it is told.
class TimedReader
{
public:
    /// `file`: its number; it stays with whoever opened it.
    explicit TimedReader(int file = -1) : _file(file) {}

    /// Reads up to the next `mark`, which is taken away. Units: seconds. `text` is empty where it is not
    /// complete.
    ReadEnd until(std::string_view mark, double withinS, std::string& text);

    /// Throws away all that has come so far.
    void discard();

    /// The same that is left when a reading was not complete.
    const std::string& pending() const { return _pending; }

private:
    int _file;
    std::string _pending;
};

} // namespace simulation
