// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <utility>

#include <foundation/Error.h>

namespace foundation
{

/// A kept error is an Error, or none, in the room of a pointer. What it does with one is not inlined: every
/// unit of the tree has hundreds of Results, and their copies and ends are a twentieth of its compilation
/// otherwise.
class KeptError
{
public:
    KeptError() = default;
    [[gnu::noinline]] explicit KeptError(Error error) : _error(new Error(std::move(error))) {}
    KeptError(KeptError&& other) noexcept : _error(std::exchange(other._error, nullptr)) {}
    [[gnu::noinline]] KeptError(const KeptError& other)
        : _error(other._error ? new Error(*other._error) : nullptr)
    {
    }
    KeptError& operator=(KeptError other) noexcept
    {
        std::swap(_error, other._error);
        return *this;
    }
    ~KeptError()
    {
        if (_error) release();
    }
    const Error& get() const
    {
        assert(_error && "the error of a Result without one was read");
        return *_error;
    }

private:
    [[gnu::noinline]] void release() { delete _error; }
    Error* _error = nullptr;
};

} // namespace foundation
