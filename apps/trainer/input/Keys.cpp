// SPDX-License-Identifier: Apache-2.0
#include "input/Keys.h"

#include <array>

namespace trainer
{

namespace
{

struct NamedKey
{
    std::string_view name;
    int code;
};

// Source: X.Org, keysymdef.h of the X11 protocol.
constexpr std::array kNamedKeys{
    NamedKey{"Space", 0x20},        NamedKey{"Comma", 0x2c},       NamedKey{"Minus", 0x2d},
    NamedKey{"Period", 0x2e},       NamedKey{"Slash", 0x2f},       NamedKey{"Semicolon", 0x3b},
    NamedKey{"Equal", 0x3d},        NamedKey{"BracketLeft", 0x5b}, NamedKey{"Backslash", 0x5c},
    NamedKey{"BracketRight", 0x5d}, NamedKey{"BackSpace", 0xff08}, NamedKey{"Tab", 0xff09},
    NamedKey{"Return", 0xff0d},     NamedKey{"Escape", 0xff1b},    NamedKey{"Home", 0xff50},
    NamedKey{"Left", 0xff51},       NamedKey{"Up", 0xff52},        NamedKey{"Right", 0xff53},
    NamedKey{"Down", 0xff54},       NamedKey{"PageUp", 0xff55},    NamedKey{"PageDown", 0xff56},
    NamedKey{"End", 0xff57},        NamedKey{"Insert", 0xff63},    NamedKey{"Delete", 0xffff},
};
constexpr int kF1 = 0xffbe, kFunctionKeys = 12;

bool isPlain(int code)
{
    return (code >= 'a' && code <= 'z') || (code >= '0' && code <= '9');
}

} // namespace

std::optional<int> keyOf(std::string_view name)
{
    if (name.size() == 1 && isPlain(name[0])) return name[0];
    for (const NamedKey& key : kNamedKeys)
        if (key.name == name) return key.code;
    for (int i = 1; i <= kFunctionKeys; ++i)
        if (name == "F" + std::to_string(i)) return kF1 + i - 1;
    return std::nullopt;
}

std::string keyName(int code)
{
    if (isPlain(code)) return {static_cast<char>(code)};
    for (const NamedKey& key : kNamedKeys)
        if (key.code == code) return std::string(key.name);
    if (code >= kF1 && code < kF1 + kFunctionKeys) return "F" + std::to_string(code - kF1 + 1);
    return "key " + std::to_string(code);
}

} // namespace trainer
