// SPDX-License-Identifier: Apache-2.0
#include "Units.h"

#include <fstream>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

namespace
{

/// The include folders and the object of a compiler's command line.
void readCommand(const std::string& command, Unit& unit, std::vector<std::string>& own,
                 std::vector<std::string>& others)
{
    std::istringstream words(command);
    for (std::string word; words >> word;)
    {
        if (word == "-o")
            words >> unit.object;
        else if (word == "-isystem" && words >> word)
            others.push_back(word);
        else if (word.starts_with("-I") && !word.ends_with("/forbidden-headers"))
            own.push_back(word.substr(2));
    }
}

void keepFirsts(std::vector<std::string>& names)
{
    std::set<std::string> seen;
    std::erase_if(names, [&](const std::string& name) { return !seen.insert(name).second; });
}

} // namespace

foundation::Result<Units> readUnits(const std::filesystem::path& buildFolder)
{
    const std::filesystem::path file = buildFolder / "compile_commands.json";
    const foundation::Error unusable{file.string(), "cannot be read as a list of compile commands",
                                     "configure the build: cmake --preset release"};
    std::ifstream stream(file);
    const nlohmann::json list = nlohmann::json::parse(stream, nullptr, false);
    if (!list.is_array() || list.empty()) return unusable;
    Units found;
    std::vector<std::string> others;
    for (const nlohmann::json& entry : list)
    {
        if (!entry.is_object() || !entry.contains("command") || !entry.contains("file")) return unusable;
        if (!entry["command"].is_string() || !entry["file"].is_string()) return unusable;
        Unit unit{"", entry["file"].get<std::string>()};
        readCommand(entry["command"].get<std::string>(), unit, found.folders, others);
        found.units.push_back(std::move(unit));
    }
    found.folders.insert(found.folders.end(), others.begin(), others.end());
    keepFirsts(found.folders);
    return found;
}

foundation::Result<std::vector<std::string>> readList(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    if (!stream) return foundation::Error{file.string(), "cannot be read", "write the list anew"};
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}
