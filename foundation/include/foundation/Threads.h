// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace foundation
{

/// Returns how many threads this machine runs at once, 1 at least. Asked once: the system reads a file for
/// each answer, 10 us.
inline std::size_t processors()
{
    static const std::size_t count = std::max(1U, std::thread::hardware_concurrency());
    return count;
}

/// A group of threads whose failures are not lost. Where the system has no further thread, work is done at
/// once in the calling one.
/// Errors: join() throws the first exception that left some work, as std::bad_alloc; the destructor waits,
/// and forgets it.
class Threads
{
public:
    Threads() = default;
    ~Threads() { wait(); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    /// Does `work` in a thread of its own.
    template<class Work>
    void run(Work work)
    {
        _threads.reserve(_threads.size() + 1);
        try
        {
            _threads.emplace_back([this, work] { guard(work); });
        }
        catch (const std::system_error&) // no further thread, or no memory for its stack
        {
            guard(work);
        }
    }

    /// Waits for all work.
    void join()
    {
        wait();
        if (_failure) std::rethrow_exception(std::exchange(_failure, nullptr));
    }

private:
    template<class Work>
    void guard(const Work& work)
    {
        try
        {
            work();
        }
        catch (...)
        {
            const std::lock_guard lock(_mutex);
            if (!_failure) _failure = std::current_exception();
        }
    }

    void wait()
    {
        for (std::thread& thread : _threads)
            thread.join();
        _threads.clear();
    }

    std::mutex _mutex;
    std::exception_ptr _failure;
    std::vector<std::thread> _threads;
};

} // namespace foundation
