// SPDX-License-Identifier: Apache-2.0
#include "Glslang.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <sys/wait.h>

#include "TestFolder.h"

namespace shadercheck
{

namespace
{

/// Runs the validator; returns what it printed. It exits with 2 or 3 on faults of shaders.
std::string runValidator(const std::string& arguments)
{
    const std::string validator = OSGTRAINER_GLSLANG_VALIDATOR;
    if (validator.find("NOTFOUND") != std::string::npos)
        throw std::runtime_error("glslangValidator: not found at configuration; install glslang-tools");
    std::FILE* pipe = ::popen((validator + arguments + " 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error(validator + ": cannot be started");
    std::string output;
    std::array<char, 4096> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe))
        output.append(block.data(), count);
    const int status = ::pclose(pipe);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (code != 0 && code != 2 && code != 3)
        throw std::runtime_error(validator + ": ended with " + std::to_string(code) + ": " + output);
    if (code != 0 && output.find("ERROR: ") == std::string::npos)
        throw std::runtime_error(validator + ": failed without an error: " + output);
    return output;
}

/// The validator prints a line with the name of each file, then its errors; last, those of linking.
std::vector<Fault> faultsIn(const std::string& output, const std::map<std::string, const Composition*>& files)
{
    static const std::regex kError(R"(ERROR: 0:(\d+): (.*))");
    std::vector<Fault> faults;
    const Composition* current = nullptr;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
    {
        std::smatch found;
        if (const auto file = files.find(line); file != files.end())
            current = file->second;
        else if (std::regex_match(line, found, kError))
            faults.push_back({current, std::stoi(found[1]), found[2]});
        else if (line.starts_with("ERROR: Linking"))
            faults.push_back({nullptr, 0, line});
        else if (!faults.empty() && !faults.back().composition && !line.empty())
            faults.back().message += " " + line;
    }
    return faults;
}

/// Runs the validator on compositions. `files`: becomes which composition each file name stands for.
std::string outputFor(const std::string& options, const Composition* first, std::size_t count,
                      std::map<std::string, const Composition*>& files)
{
    const testsupport::TestFolder folder("shaders");
    std::string arguments = options;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Composition& composition = first[i];
        const std::string file =
            folder.write("s" + std::to_string(i) + "." + composition.stage, composition.text).string();
        files[file] = &composition;
        arguments += " " + file;
    }
    return runValidator(arguments);
}

std::vector<Fault> validate(const std::string& options, const Composition* first, std::size_t count)
{
    std::map<std::string, const Composition*> files;
    const std::string output = outputFor(options, first, count, files);
    return faultsIn(output, files);
}

} // namespace

std::vector<Fault> compileAll(const std::vector<Composition>& compositions)
{
    constexpr std::size_t kAtOnce = 100;
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < compositions.size(); i += kAtOnce)
        for (const Fault& fault :
             validate("", compositions.data() + i, std::min(kAtOnce, compositions.size() - i)))
            faults.push_back(fault);
    return faults;
}

std::vector<Fault> linkProgram(const std::vector<Composition>& stages)
{
    return validate(" -l", stages.data(), stages.size());
}

int samplersOf(const std::vector<Composition>& stages)
{
    // GL_SAMPLER_2D, _2D_SHADOW, _2D_ARRAY in the list of uniforms that are read.
    static const std::regex kSampler(R"(\n\w+: offset -?\d+, type (8b5e|8b62|8dc1),)");
    std::map<std::string, const Composition*> files;
    const std::string output = outputFor(" -l -q", stages.data(), stages.size(), files);
    return static_cast<int>(
        std::distance(std::sregex_iterator(output.begin(), output.end(), kSampler), std::sregex_iterator()));
}

} // namespace shadercheck
