// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <optional>
#include <utility>
#include <variant>

#include <foundation/Error.h>
#include <foundation/KeptError.h>

namespace foundation
{

/// A result holds either a value or the Error that kept it from existing. Failures of data are values, never
/// exceptions: an exception must not cross a scene-graph traversal or a C callback.
/// Errors: reading the absent side is a broken contract (assert).
template<class T>
class [[nodiscard]] Result
{
public:
    Result(T value) : _value(std::in_place, std::move(value)) {}
    Result(Error error) : _error(std::move(error)) {}

    explicit operator bool() const { return _value.has_value(); }
    T& value()
    {
        assert(_value && "the value of a Result without one was read");
        return *_value;
    }
    const T& value() const
    {
        assert(_value && "the value of a Result without one was read");
        return *_value;
    }
    const Error& error() const { return _error.get(); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::optional<T> _value;
    KeptError _error;
};

/// An outcome is the result of an action that returns no value.
using Outcome = Result<std::monostate>;

inline Outcome success()
{
    return std::monostate{};
}

} // namespace foundation
