// SPDX-License-Identifier: Apache-2.0
#include "input/KeyScript.h"

#include <algorithm>

#include <foundation/Excerpt.h>
#include <foundation/WholeText.h>

#include "input/Keys.h"
#include "input/LineReader.h"

namespace trainer
{

namespace
{

constexpr std::uintmax_t kMostScriptBytes = 4U << 20;
constexpr std::size_t kMostEvents = 100'000;
constexpr double kTapS = 0.02, kMostS = 1e6, kMostPx = 8192.0;

class KeyScriptReader
{
public:
    foundation::Outcome take(const TextLine& line)
    {
        using Kind = WindowEvent::Kind;
        const auto& cells = line.cells;
        const auto at = numberIn(cells[0], _lastS, kMostS);
        if (!at)
            return wrong(line, "'" + foundation::excerpt(cells[0]) + "' is no time after the line above",
                         "write seconds since the window opened, ascending");
        _lastS = *at;
        const std::string_view word = cells.size() > 1 ? cells[1] : std::string_view();
        if (events.size() > kMostEvents) return wrong(line, "more than 100000 events", "shorten it");
        if (word == "close" && cells.size() == 2) return add({*at, Kind::close});
        if (word == "resize" && cells.size() == 4) return takeSize(line, *at);
        if ((word == "press" || word == "release" || word == "tap") && cells.size() == 3)
            return takeKey(line, *at, word == "tap" ? kTapS : 0.0);
        if (word == "hold" && cells.size() == 4)
        {
            const auto length = numberIn(cells[3], 0.0, kMostS);
            if (length) return takeKey(line, *at, std::max(kTapS, *length));
        }
        return wrong(
            line, "no line of keys",
            "write TIME press|release|tap KEY, TIME hold KEY SECONDS, TIME resize W H, or TIME close");
    }

    std::vector<WindowEvent> events;

private:
    static foundation::Error wrong(const TextLine& line, const std::string& what, const std::string& remedy)
    {
        return {line.place, what, remedy};
    }

    foundation::Outcome add(const WindowEvent& event)
    {
        events.push_back(event);
        return foundation::success();
    }

    foundation::Outcome takeSize(const TextLine& line, double at)
    {
        const auto width = numberIn(line.cells[2], 16.0, kMostPx),
                   height = numberIn(line.cells[3], 16.0, kMostPx);
        if (!width || !height) return wrong(line, "that is no size", "write pixels, 16 to 8192");
        return add({at, WindowEvent::Kind::resize, 0, static_cast<int>(*width), static_cast<int>(*height)});
    }

    /// `heldS`: until the key comes up; 0: the line says one of both alone.
    foundation::Outcome takeKey(const TextLine& line, double at, double heldS)
    {
        const auto key = keyOf(line.cells[2]);
        if (!key)
            return wrong(line, "there is no key '" + foundation::excerpt(line.cells[2]) + "'",
                         "write a letter, a digit, F1 to F12 or a name such as PageUp");
        const bool isUp = line.cells[1] == "release";
        events.push_back({at, isUp ? WindowEvent::Kind::release : WindowEvent::Kind::press, *key});
        if (heldS > 0.0) events.push_back({at + heldS, WindowEvent::Kind::release, *key});
        return foundation::success();
    }

    double _lastS = 0.0;
};

} // namespace

foundation::Result<std::vector<WindowEvent>> parseKeyScript(std::string_view text, const std::string& name)
{
    KeyScriptReader reader;
    if (const auto read = readLines(text, name, "osgtrainer-keys 1",
                                    [&](const TextLine& line) { return reader.take(line); });
        !read)
        return read.error();
    std::stable_sort(reader.events.begin(), reader.events.end(),
                     [](const WindowEvent& a, const WindowEvent& b) { return a.atS < b.atS; });
    return std::move(reader.events);
}

foundation::Result<std::vector<WindowEvent>> readKeyScript(const std::filesystem::path& file)
{
    const auto text = foundation::readWholeText(file, kMostScriptBytes);
    if (!text) return text.error();
    return parseKeyScript(*text, file.string());
}

} // namespace trainer
