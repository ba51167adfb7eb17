// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace trainer
{

/// What happens to a window at a time: a key goes down or up, the window is resized or closed.
struct WindowEvent
{
    enum class Kind
    {
        press,
        release,
        resize,
        close
    };

    double atS = 0.0; ///< since the window opened
    Kind kind = Kind::press;
    int key = 0; ///< of press and release
    int widthPx = 0, heightPx = 0;
};

/// Reads a key script (docs/reference/key-script.md), a test aid: keys at times, as if somebody pressed them.
/// Events come in the order of time. `name` stands for the file in errors. Errors, with the line: no or
/// another first line, an unknown word or key, a time that is none or before the line above, a wrong number
/// of cells, more than 100 000 lines.
foundation::Result<std::vector<WindowEvent>> parseKeyScript(std::string_view text, const std::string& name);

/// Errors: besides those a file that cannot be read or is larger than 4 MiB.
foundation::Result<std::vector<WindowEvent>> readKeyScript(const std::filesystem::path& file);

} // namespace trainer
