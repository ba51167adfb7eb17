// SPDX-License-Identifier: Apache-2.0
#include "terminal/Progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <thread>

#include <unistd.h>

namespace terminal
{

namespace
{

constexpr auto kQuiet = std::chrono::seconds(2);
constexpr auto kBetween = std::chrono::milliseconds(250); ///< two drawings on a terminal

} // namespace

std::string ProgressText::text() const
{
    std::string text = label;
    if (!step.empty()) text += ": " + step;
    if (step.empty() && (done > 0 || total > 0)) text += ": " + std::to_string(done);
    if (step.empty() && total > 0) text += '/' + std::to_string(total);
    if (!step.empty() && total > 0) text += ", " + std::to_string(100 * done / total) + " % done";
    text += ", " + std::to_string(std::lround(pastS)) + " s";
    if (done == 0 || done >= total) return text;
    const double leftS = pastS * static_cast<double>(total - done) / static_cast<double>(done);
    return text + ", about " + std::to_string(std::lround(leftS)) + " s left";
}

/// What is shown of a progress.
class Progress::Line
{
public:
    Line(std::string label, std::size_t total) : _isTerminal(isatty(STDERR_FILENO) != 0)
    {
        _text.label = std::move(label);
        _text.total = total;
        if (_isTerminal) _drawing = std::thread([this] { redraw(); });
    }

    ~Line()
    {
        {
            const std::lock_guard lock(_mutex);
            _isEnded = true;
        }
        _end.notify_all();
        if (_drawing.joinable()) _drawing.join();
        if (_isDrawn) std::cerr << '\n';
    }

    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    void advance()
    {
        const std::lock_guard lock(_mutex);
        ++_text.done;
        const std::size_t step = _text.total > 0 ? std::max<std::size_t>(_text.total / 10, 1) : 100;
        if (_text.done % step == 0 || _text.done == _text.total) print();
    }

    void begin(const std::string& step, std::size_t shares)
    {
        const std::lock_guard lock(_mutex);
        _text.done += _shares;
        _shares = shares;
        _text.step = step;
        print();
    }

private:
    using Clock = std::chrono::steady_clock;

    std::string text()
    {
        _text.pastS = std::chrono::duration<double>(Clock::now() - _since).count();
        return _text.text();
    }

    void print()
    {
        if (!_isTerminal && Clock::now() - _since >= kQuiet) std::cerr << text() + '\n';
    }

    void redraw()
    {
        std::unique_lock lock(_mutex);
        _end.wait_for(lock, kQuiet, [this] { return _isEnded; });
        while (!_isEnded)
        {
            std::cerr << "\r\x1b[K" + text() << std::flush;
            _isDrawn = true;
            _end.wait_for(lock, kBetween, [this] { return _isEnded; });
        }
    }

    ProgressText _text;
    std::size_t _shares = 0; ///< of the step
    Clock::time_point _since = Clock::now();
    bool _isTerminal, _isDrawn = false, _isEnded = false;
    std::mutex _mutex;
    std::condition_variable _end;
    std::thread _drawing; ///< on a terminal
};

Progress::Progress(std::string label, std::size_t total)
    : _line(std::make_unique<Line>(std::move(label), total))
{
}

Progress::~Progress() = default;

void Progress::advance()
{
    _line->advance();
}

void Progress::begin(const std::string& step, std::size_t shares)
{
    _line->begin(step, shares);
}

} // namespace terminal
