// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace peers
{

/// Positions and triangles, numbered from 0.
struct PlainMesh
{
    std::vector<std::array<double, 3>> positions;
    std::vector<std::vector<std::size_t>> triangles;
};

/// Reads the `v x y z` and `f a b c` lines that pmtool writes.
inline PlainMesh readPlainObj(const std::filesystem::path& file)
{
    PlainMesh mesh;
    std::ifstream stream(file);
    std::string line;
    while (std::getline(stream, line))
    {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v")
        {
            auto& p = mesh.positions.emplace_back();
            words >> p[0] >> p[1] >> p[2];
        }
        else if (kind == "f")
        {
            std::array<std::size_t, 3> t{};
            words >> t[0] >> t[1] >> t[2];
            mesh.triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
        }
    }
    return mesh;
}

} // namespace peers
