// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>
#include <optional>

#include <osgMultiTriangulation/core/input/TinFile.h>

#include "CountedSink.h"
#include "TinCollector.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Takes the next word of a line; empty: there is none.
std::string_view wordOf(std::string_view& line)
{
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    line.remove_prefix(first);
    const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
    line.remove_prefix(word.size());
    return word;
}

class ObjReader
{
public:
    ObjReader(std::string name, TinSink& sink) : _name(std::move(name)), _sink(sink) {}

    foundation::Outcome read(std::string_view text)
    {
        while (!text.empty())
        {
            ++_line;
            const std::size_t end = std::min(text.find('\n'), text.size());
            if (const auto taken = take(text.substr(0, end)); !taken) return taken.error();
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        if (_sink.triangles() == 0)
            return foundation::Error{_name, "has no faces", "give a surface of triangles"};
        return foundation::success();
    }

private:
    foundation::Outcome take(std::string_view line)
    {
        const std::string_view keyword = wordOf(line);
        if (keyword == "v") return takePoint(line);
        if (keyword == "f") return takeFace(line);
        return foundation::success();
    }

    foundation::Outcome takePoint(std::string_view line)
    {
        MeasuredPoint point{};
        for (double& value : point)
        {
            std::string_view word = wordOf(line);
            if (word.starts_with('+')) word.remove_prefix(1);
            const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (failed != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
                return failure("has a vertex without three numbers");
        }
        _sink.add(point);
        return foundation::success();
    }

    foundation::Outcome takeFace(std::string_view line)
    {
        std::uint32_t first = 0, before = 0;
        int corners = 0;
        for (std::string_view word = wordOf(line); !word.empty(); word = wordOf(line))
        {
            const auto corner = cornerOf(word);
            if (!corner) return failure("has a face with a vertex that is not there");
            if (corners == 0) first = *corner;
            if (corners >= 2) _sink.add(Triangle{first, before, *corner});
            before = *corner;
            ++corners;
        }
        if (corners < 3) return failure("has a face of less than three vertices");
        return foundation::success();
    }

    /// The vertex of "7", "7/1/2" or "-1": from 1 on, or back from the last.
    std::optional<std::uint32_t> cornerOf(std::string_view word) const
    {
        word = word.substr(0, word.find('/'));
        std::int64_t number = 0;
        const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), number);
        const auto count = static_cast<std::int64_t>(_sink.points());
        if (failed != std::errc() || end != word.data() + word.size()) return std::nullopt;
        const std::int64_t place = number < 0 ? count + number : number - 1;
        if (place < 0 || place >= count) return std::nullopt;
        return static_cast<std::uint32_t>(place);
    }

    foundation::Error failure(const std::string& what) const
    {
        return {_name + ":" + std::to_string(_line), what, "write \"v X Y Z\" before \"f A B C\""};
    }

    std::string _name;
    std::size_t _line = 0;
    CountedSink _sink;
};

} // namespace

foundation::Outcome streamObj(std::string_view text, const std::string& name, TinSink& sink)
{
    return ObjReader(name, sink).read(text);
}

foundation::Result<MeasuredTin> parseObj(std::string_view text, const std::string& name)
{
    TinCollector collector;
    if (const auto read = streamObj(text, name, collector); !read) return read.error();
    return std::move(collector.tin);
}

} // namespace osgMultiTriangulation::core
