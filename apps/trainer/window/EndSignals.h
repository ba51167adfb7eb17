// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>
#include <cstddef>
#include <iterator>

namespace trainer
{

/// As long as it lives, SIGINT, SIGTERM and SIGHUP are noted instead of ending the process, so that
/// recordings are written. A second one of a kind ends it. Threads: one of it in a process.
class EndSignals
{
public:
    EndSignals()
    {
        isCome() = 0;
        for (std::size_t i = 0; i < kCount; ++i)
            _before[i] = std::signal(kSignals[i], note);
    }

    ~EndSignals()
    {
        for (std::size_t i = 0; i < kCount; ++i)
            std::signal(kSignals[i], _before[i]);
    }

    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    bool haveCome() const { return isCome() != 0; }

private:
    static constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
    static constexpr std::size_t kCount = std::size(kSignals);

    static volatile std::sig_atomic_t& isCome()
    {
        static volatile std::sig_atomic_t come = 0;
        return come;
    }

    static void note(int signal)
    {
        isCome() = 1;
        std::signal(signal, SIG_DFL);
    }

    void (*_before[kCount])(int) = {};
};

} // namespace trainer
