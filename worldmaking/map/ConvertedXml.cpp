// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/ConvertedXml.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include <foundation/Utf8.h>
#include <zlib.h>

namespace worldmaking
{

namespace
{

bool isXmlByName(std::filesystem::path file)
{
    if (file.extension() == ".gz") file = file.stem();
    return file.extension() == ".osm" || file.extension() == ".xml";
}

} // namespace

foundation::Result<std::optional<std::string>> convertedXml(const std::filesystem::path& file)
{
    constexpr unsigned kHeadBytes = 1024, kPieceBytes = 1 << 16;
    using Closer = decltype([](gzFile stream) { gzclose(stream); });
    const std::unique_ptr<gzFile_s, Closer> stream(gzopen(file.c_str(), "rb"));
    std::optional<std::string> converted;
    if (!stream || !isXmlByName(file)) return converted;
    std::string text(kHeadBytes, '\0');
    text.resize(static_cast<std::size_t>(std::max(0, gzread(stream.get(), text.data(), kHeadBytes))));
    const std::string named = foundation::xmlEncodingOf(text);
    const bool isWide = foundation::wideEncodingOf(text).has_value();
    const auto isPlain = [](std::string_view name)
    { return name.empty() || name == "UTF-8" || name == "utf-8" || name == "Utf-8"; };
    if (!isWide && isPlain(named)) return converted;
    for (int count = 1; count > 0;)
    {
        const std::size_t before = text.size();
        text.resize(before + kPieceBytes);
        count = gzread(stream.get(), text.data() + before, kPieceBytes);
        text.resize(before + static_cast<std::size_t>(std::max(0, count)));
    }
    const auto read = foundation::Utf8Text::of(text, named, file.string());
    if (!read) return read.error();
    converted = std::string(read->in(text));
    // The parser believes the declaration, which is no longer true.
    const std::size_t begin = converted->find("<?xml"), end = converted->find("?>");
    if (begin < end && end != std::string::npos)
        converted->replace(begin, end - begin, "<?xml version=\"1.0\"");
    return converted;
}

} // namespace worldmaking
