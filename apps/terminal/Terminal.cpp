// SPDX-License-Identifier: Apache-2.0
#include "terminal/Terminal.h"

#include <algorithm>
#include <cctype>
#include <iostream>

#include <foundation/Excerpt.h>
#include <unistd.h>

namespace terminal
{

int fail(const std::string& program, const foundation::Error& error)
{
    const foundation::Error shortened{error.place, foundation::excerpt(error.what), error.remedy};
    std::string message = shortened.message();
    std::replace_if(
        message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    std::cerr << program << ": " << message << '\n';
    return kFailed;
}

Progress::Progress(std::string label, std::size_t total)
    : _label(std::move(label)), _total(total), _isTerminal(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
    if (_isTerminal && _done > 0) std::cerr << '\n';
}

void Progress::advance()
{
    ++_done;
    const std::size_t step = _total > 0 ? std::max<std::size_t>(_total / 10, 1) : 100;
    if (_isTerminal || _done % step == 0 || _done == _total) print();
}

void Progress::print() const
{
    constexpr std::size_t kWidth = 40;
    const std::string count =
        _total > 0 ? std::to_string(_done) + '/' + std::to_string(_total) : std::to_string(_done);
    if (!_isTerminal)
    {
        std::cerr << _label << ": " << count << '\n';
        return;
    }
    const std::size_t filled = _total > 0 ? kWidth * _done / _total : 0;
    const std::string bar =
        _total > 0 ? " [" + std::string(filled, '=') + std::string(kWidth - filled, ' ') + "] " : " ";
    std::cerr << '\r' << _label << bar << count << std::flush;
}

} // namespace terminal
