// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

namespace testsupport
{

/// All bytes of a file; none of one that cannot be read.
inline std::string bytesOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A temporary folder that goes away.
class TestFolder
{
public:
    explicit TestFolder(const std::string& name)
        : _path(std::filesystem::temp_directory_path() /
                (name + "-" + std::to_string(::getpid()) + "-" + std::to_string(_count++)))
    {
        std::filesystem::create_directories(_path);
    }
    ~TestFolder() { std::filesystem::remove_all(_path); }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return _path / name; }

    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        std::ofstream(_path / name) << text;
        return _path / name;
    }

private:
    static inline int _count = 0;
    std::filesystem::path _path;
};

} // namespace testsupport
