// SPDX-License-Identifier: Apache-2.0
#include "SimulatedTrack.h"

#include <array>
#include <sstream>

#include <zlib.h>

namespace simulation
{
namespace
{

std::string inflated(const std::filesystem::path& file)
{
    std::string text;
    gzFile stream = gzopen(file.c_str(), "rb");
    if (!stream) return text;
    std::array<char, 65536> chunk{};
    for (int read = gzread(stream, chunk.data(), chunk.size()); read > 0;
         read = gzread(stream, chunk.data(), chunk.size()))
        text.append(chunk.data(), static_cast<std::size_t>(read));
    gzclose(stream);
    return text;
}

std::vector<std::string> fields(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');)
    {
        const std::size_t begin = cell.find_first_not_of(" \r");
        const std::size_t end = cell.find_last_not_of(" \r");
        cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
    }
    return cells;
}

} // namespace

SimulatedTrack readSimulatedTrack(const std::filesystem::path& file)
{
    SimulatedTrack track;
    std::istringstream stream(inflated(file));
    std::vector<std::string> header;
    for (std::string line; std::getline(stream, line);)
    {
        const std::vector<std::string> cells = fields(line);
        if (header.empty())
        {
            if (line.starts_with("Index")) header = cells;
            continue;
        }
        track.timeS.push_back(std::stod(cells.at(1)));
        for (std::size_t i = 2; i < cells.size() && i < header.size(); ++i)
        {
            if (header[i].size() < 3 || header[i][0] != '#') continue;
            const std::string name = header[i].substr(3, header[i].find_first_of(" [", 3) - 3);
            char* end = nullptr;
            const double value = std::strtod(cells[i].c_str(), &end);
            if (end != cells[i].c_str()) track.columns[{header[i][1] - '0', name}].push_back(value);
        }
    }
    return track;
}

} // namespace simulation
