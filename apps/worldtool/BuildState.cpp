// SPDX-License-Identifier: Apache-2.0
#include "worldtool/BuildState.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

#include <foundation/Fnv1a.h>
#include <foundation/WholeFile.h>

namespace worldtool
{

namespace
{

constexpr const char* kName = "build.json";

/// A sum over texts and files.
class Sum
{
public:
    /// With the zero at its end, so that texts after one another cannot be taken for others.
    void add(const std::string& text) { _hash.add({text.c_str(), text.size() + 1}); }

    /// Returns false where the file cannot be read.
    bool addFile(const std::filesystem::path& file)
    {
        std::ifstream stream(file, std::ios::binary);
        if (!stream) return false;
        std::array<char, 65536> bytes{};
        while (stream.read(bytes.data(), bytes.size()) || stream.gcount() > 0)
            _hash.add({bytes.data(), static_cast<std::size_t>(stream.gcount())});
        return stream.eof();
    }

    std::string text() const { return _hash.text(); }

private:
    foundation::Fnv1a _hash;
};

std::optional<std::string> sumOf(const std::filesystem::path& file)
{
    Sum sum;
    return sum.addFile(file) ? std::optional(sum.text()) : std::nullopt;
}

/// The files of a folder and of the folders in it, by name; none of a file.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code failed;
    if (!std::filesystem::is_directory(folder, failed)) return files;
    auto entry = std::filesystem::recursive_directory_iterator(folder, failed);
    for (; !failed && entry != std::filesystem::recursive_directory_iterator(); entry.increment(failed))
    {
        if (entry.depth() >= 2) entry.disable_recursion_pending();
        files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

foundation::Result<BuildState> BuildState::open(const Request& request)
{
    Sum sum;
    sum.add(request.version);
    (void)sum.addFile("/proc/self/exe"); // another program may make another world
    sum.add(std::to_string(request.seed) + ' ' + std::to_string(request.aridity.value_or(-1.0)));
    for (const double bound : request.bounds)
        sum.add(std::to_string(bound));
    std::vector<std::filesystem::path> inputs = request.dems;
    inputs.push_back(request.runways);
    inputs.push_back(request.landCover);
    inputs.push_back(request.landCoverClasses);
    std::error_code ignored;
    for (const auto& map : request.maps) // in their order: the later one counts
    {
        inputs.push_back(map);
        const auto files = filesIn(map);
        inputs.insert(inputs.end(), files.begin(), files.end());
    }
    for (const auto& input : inputs)
    {
        sum.add(input.string());
        if (std::filesystem::is_regular_file(input, ignored) && !sum.addFile(input))
            return foundation::Error{input.string(), "cannot be read", "check the path and its permissions"};
    }
    BuildState state;
    state._world = request.world;
    std::ifstream stream(request.world / kName);
    const auto read = nlohmann::ordered_json::parse(stream, nullptr, false);
    const std::string inputsSum = sum.text();
    const bool isSame = read.is_object() && read.contains("inputs") && read["inputs"] == inputsSum &&
                        read.contains("files") && read["files"].is_object();
    state._json =
        isSame ? read
               : nlohmann::ordered_json{{"inputs", inputsSum}, {"files", nlohmann::ordered_json::object()}};
    return state;
}

bool BuildState::has(const std::string& name) const
{
    const auto& files = _json["files"];
    const auto found = files.find(name);
    const auto sum = found == files.end() ? std::nullopt : sumOf(_world / name);
    return sum && *found == *sum;
}

bool BuildState::isWhole() const
{
    if (!has("world.roam")) return false;
    for (const auto& [name, sum] : _json["files"].items())
        if (!has(name)) return false;
    return true;
}

foundation::Outcome BuildState::note(const std::string& name)
{
    const auto sum = sumOf(_world / name);
    if (!sum)
        return foundation::Error{(_world / name).string(), "cannot be read",
                                 "check the path and its permissions"};
    _json["files"][name] = *sum;
    return foundation::writeWholeFile(_world / kName, _json.dump(1) + '\n');
}

} // namespace worldtool
