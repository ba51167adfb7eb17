// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

#include <osgPMObjects/core/Triangle.h>

#include "compare/objects/ChildProgram.h"
#include "compare/objects/SimplifyTool.h"
#include "pmtool/ModelFiles.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
namespace fs = std::filesystem;

/// A temporary folder of this process, removed at the end.
class WorkFolder
{
public:
    WorkFolder()
    {
        std::string name = (fs::temp_directory_path() / "pmtool-XXXXXX").string();
        if (mkdtemp(name.data())) _path = name;
    }
    ~WorkFolder()
    {
        std::error_code ignored;
        if (!_path.empty()) fs::remove_all(_path, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    const fs::path& path() const { return _path; } ///< empty: it could not be made

private:
    fs::path _path;
};

/// Returns the last line of a file that is not empty.
std::string lastWords(const fs::path& file)
{
    std::ifstream stream(file);
    std::string line, last;
    while (std::getline(stream, line))
        if (!line.empty()) last = line;
    return last;
}

/// Reads `v` and `f` lines; faces are triangles. Errors: an index beyond the positions, words that are no
/// numbers.
foundation::Result<core::Mesh> readPlain(const fs::path& file)
{
    std::ifstream stream(file);
    if (!stream)
        return foundation::Error{file.filename().string(), "was not written", "let the program write it"};
    std::vector<glm::dvec3> positions;
    std::vector<core::Triangle> triangles;
    std::string line;
    while (std::getline(stream, line))
    {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v")
        {
            glm::dvec3& p = positions.emplace_back();
            words >> p.x >> p.y >> p.z;
        }
        else if (kind == "f")
        {
            core::Triangle& t = triangles.emplace_back();
            words >> t[0] >> t[1] >> t[2];
            for (std::uint32_t& corner : t)
                if (--corner >= positions.size()) words.setstate(std::ios::failbit);
        }
        if (words.fail())
            return foundation::Error{file.filename().string(), "cannot be understood: " + line,
                                     "let the program write `v x y z` and `f a b c`"};
    }
    return shapeOf(positions, triangles);
}

/// Reads lines of a count and a time; other lines are ignored.
std::map<std::size_t, double> readTimes(const fs::path& file)
{
    std::map<std::size_t, double> times;
    std::ifstream stream(file);
    std::string line;
    while (std::getline(stream, line))
    {
        std::istringstream words(line);
        std::size_t count = 0;
        double ms = 0.0;
        if (words >> count >> ms) times[count] = ms;
    }
    return times;
}

foundation::Result<std::vector<SimplifiedLevel>> run(const fs::path& program, const SimplifyTask& task)
{
    const WorkFolder folder;
    if (folder.path().empty())
        return foundation::Error{fs::temp_directory_path().string(), "no folder can be made there",
                                 "set TMPDIR"};
    const fs::path input = folder.path() / "in.obj", said = folder.path() / "said.txt";
    if (const auto written = writePlain(task.shape, input); !written) return written.error();
    std::vector<std::string> command{program.string(), input.string(), folder.path().string()};
    for (const std::size_t target : task.targets)
        command.push_back(std::to_string(target));
    if (const auto ran = runProgram(command, said, task.seconds); !ran)
    {
        foundation::Error error = ran.error();
        if (const std::string words = lastWords(said); !words.empty()) error.what += ": " + words;
        return error;
    }
    const std::map<std::size_t, double> times = readTimes(said);
    std::vector<SimplifiedLevel> levels;
    for (const std::size_t target : task.targets)
    {
        auto mesh = readPlain(folder.path() / (std::to_string(target) + ".obj"));
        if (!mesh) return mesh.error();
        const auto time = times.find(target);
        levels.push_back({*std::move(mesh), time == times.end() ? 0.0 : time->second, true});
    }
    return levels;
}

} // namespace

SimplifyTool peerTool(const std::string& name, const fs::path& program)
{
    return {name, false, [program](const SimplifyTask& task) { return run(program, task); }};
}

} // namespace pmtool
