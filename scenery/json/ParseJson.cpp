// SPDX-License-Identifier: Apache-2.0
#include "scenery/json/ParseJson.h"

#include <algorithm>
#include <fstream>

namespace scenery
{

foundation::Result<nlohmann::json> parseJson(std::string_view text, const std::string& name)
{
    using nlohmann::json;
    if (text.size() > kMostJsonBytes)
        return foundation::Error{name, "is larger than 4 MB", "give a description"};
    try
    {
        return json::parse(text, nullptr, true, true);
    }
    catch (const json::exception& failure) // the library's way to say so; it ends here
    {
        const auto* const parsing = dynamic_cast<const json::parse_error*>(&failure);
        const std::size_t byte = parsing ? std::min(parsing->byte, text.size()) : 0;
        const auto line =
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
        return foundation::Error{name + ":" + std::to_string(line), "is no JSON",
                                 "look for a comma or a bracket before this place"};
    }
}

foundation::Result<std::string> readJsonText(const std::filesystem::path& file, const std::string& what)
{
    std::ifstream stream(file, std::ios::binary);
    std::string text(kMostJsonBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    if (text.empty()) return foundation::Error{file.string(), "cannot be read or is empty", "give " + what};
    return text;
}

} // namespace scenery
