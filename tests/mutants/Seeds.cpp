// SPDX-License-Identifier: Apache-2.0
#include "Seeds.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

namespace fs = std::filesystem;

namespace seeds
{

fs::path written(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

std::string hillGrid(const std::string& header)
{
    std::ostringstream text;
    text << "ncols 33\nnrows 33\n" << header << "NODATA_value -9999\n";
    for (int row = 0; row < 33; ++row)
        for (int column = 0; column < 33; ++column)
            text << (row * (32 - row) + column * (32 - column)) / 4 << (column == 32 ? '\n' : ' ');
    return text.str();
}

std::string wavesModel()
{
    std::ostringstream text;
    for (int y = 0; y <= 12; ++y)
        for (int x = 0; x <= 12; ++x)
            text << "v " << x << ' ' << y << ' ' << 0.125 * ((x * y) % 7) << "\nvt " << x / 12.0 << ' '
                 << y / 12.0 << '\n';
    for (int y = 0; y < 12; ++y)
        for (int x = 1; x <= 12; ++x)
        {
            const int corners[] = {13 * y + x, 13 * y + x + 1, 13 * y + x + 14, 13 * y + x + 13};
            text << 'f';
            for (const int c : corners)
                text << ' ' << c << '/' << c;
            text << '\n';
        }
    return text.str();
}

Files realFiles(const fs::path& folder, std::initializer_list<const char*> extensions)
{
    Files files;
    std::error_code none;
    if (folder.empty() || !fs::is_directory(folder, none)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none))
        if (entry.is_regular_file() && entry.file_size() < (4u << 20) &&
            std::any_of(extensions.begin(), extensions.end(),
                        [&](const char* extension) { return entry.path().extension() == extension; }))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

Files joined(Files files, const Files& more)
{
    files.insert(files.end(), more.begin(), more.end());
    return files;
}

} // namespace seeds
