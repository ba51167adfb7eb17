// SPDX-License-Identifier: Apache-2.0
#include "terminal/Terminal.h"

#include <algorithm>
#include <cctype>
#include <iostream>

#include <foundation/Excerpt.h>

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

} // namespace terminal
