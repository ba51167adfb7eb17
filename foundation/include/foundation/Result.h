// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace foundation
{

/// An error says why a piece of data could not be used: where it is, what is wrong with it, what its owner can do.
struct Error
{
    std::string place;  ///< file, or file:line, or option
    std::string what;   ///< what was found
    std::string remedy; ///< what to do about it

    /// One line: "place: what; remedy".
    std::string message() const { return place + ": " + what + (remedy.empty() ? "" : "; " + remedy); }
};

/// A result holds either a value or the Error that kept it from existing. Failures of data are values, never exceptions: an
/// exception must not cross a scene-graph traversal or a C callback.
/// Errors: reading the absent side is a broken contract (assert).
template<class T>
class [[nodiscard]] Result
{
public:
    Result(T value) : _content(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : _content(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return _content.index() == 0; }
    T& value() { return *checked(std::get_if<0>(&_content)); }
    const T& value() const { return *checked(std::get_if<0>(&_content)); }
    const Error& error() const { return *checked(std::get_if<1>(&_content)); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    template<class P>
    static P* checked(P* pointer)
    {
        assert(pointer && "the other side of a Result was read");
        return pointer;
    }

    std::variant<T, Error> _content;
};

/// An outcome is the result of an action that returns no value.
using Outcome = Result<std::monostate>;

inline Outcome success()
{
    return std::monostate{};
}

} // namespace foundation
