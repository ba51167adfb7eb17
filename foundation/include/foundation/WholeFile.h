// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <foundation/Result.h>

namespace foundation
{

/// A file that appears under its final name only when it is complete. It is written under a temporary name in
/// the same folder; commit() renames it, the destructor removes it otherwise. Of a symbolic link, the target
/// is replaced. A device or a pipe (/dev/stdout) is written directly. `ending`: of the temporary name; where
/// several processes may write the same file at once, each has its own.
/// Threads: one.
class WholeFile
{
public:
    explicit WholeFile(std::filesystem::path file, std::string_view ending = ".part")
        : _asked(std::move(file)), _final(_asked), _written(_asked)
    {
        std::error_code code;
        const std::filesystem::file_status status = std::filesystem::status(_asked, code);
        const bool exists = std::filesystem::exists(status);
        if (exists && !is_regular_file(status) && !is_directory(status)) return;
        if (exists)
            if (std::filesystem::path real = std::filesystem::canonical(_asked, code); !code)
                _final = std::move(real);
        _written = _final;
        _written += ending;
    }

    ~WholeFile()
    {
        std::error_code ignored;
        if (isTemporary()) std::filesystem::remove(_written, ignored);
    }

    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// The path to write to until commit().
    const std::filesystem::path& written() const { return _written; }

    bool isTemporary() const { return _written != _final; }

    /// Gives the complete file its final name.
    Outcome commit()
    {
        if (!isTemporary()) return success();
        std::error_code failed;
        std::filesystem::rename(_written, _final, failed);
        if (failed) return failure("cannot be put in place", failed.message());
        _written = _final;
        return success();
    }

    Error failure(const std::string& what, const std::string& reason) const
    {
        return {_asked.string(), what + ": " + reason,
                "check that the folder exists, is writable and has room"};
    }

private:
    std::filesystem::path _asked, _final, _written;
};

/// Writes `bytes` as a WholeFile. Errors: no such folder, no permission, no room; then nothing is left
/// behind.
inline Outcome writeWholeFile(const std::filesystem::path& path, std::string_view bytes,
                              std::string_view ending = ".part")
{
    WholeFile file(path, ending);
    const auto reason = [] { return std::generic_category().message(errno); };
    errno = 0;
    std::ofstream stream(file.written(), std::ios::binary);
    if (!stream) return file.failure("cannot be created", reason());
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) return file.failure("cannot be written", reason());
    return file.commit();
}

/// Tells whether writeWholeFile would work, before a long computation; leaves nothing behind. An empty path
/// stands for no file and succeeds.
inline Outcome checkWritable(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (path.empty()) return success();
    if (std::filesystem::is_directory(path, ignored))
        return Error{path.string(), "is a folder", "name a file in it"};
    const WholeFile file(path);
    if (!file.isTemporary()) return success(); // opening a pipe would wait for its reader
    errno = 0;
    if (std::ofstream(file.written(), std::ios::binary).is_open()) return success();
    return file.failure("cannot be created", std::generic_category().message(errno));
}

} // namespace foundation
