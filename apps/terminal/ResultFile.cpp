// SPDX-License-Identifier: Apache-2.0
#include "terminal/ResultFile.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace terminal
{

namespace
{

/// Where the bytes go, and what that becomes.
struct Target
{
    std::filesystem::path written;
    std::filesystem::path final;

    bool isTemporary() const { return written != final; }
    void remove() const
    {
        std::error_code ignored;
        if (isTemporary()) std::filesystem::remove(written, ignored);
    }
};

Target targetOf(const std::filesystem::path& file)
{
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(file, code);
    const bool exists = std::filesystem::exists(status);
    if (exists && !std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status))
        return {file, file};
    std::filesystem::path final = file;
    if (exists)
        if (const std::filesystem::path real = std::filesystem::canonical(file, code); !code) final = real;
    std::filesystem::path temporary = final;
    temporary += ".part";
    return {temporary, final};
}

viewlod::Error failure(const std::filesystem::path& file, const std::string& what, const std::string& reason)
{
    return {file.string(), what + ": " + reason, "check that the folder exists, is writable and has room"};
}

} // namespace

viewlod::Outcome writeFile(const std::filesystem::path& file, const std::string& text)
{
    const Target target = targetOf(file);
    std::ofstream stream(target.written, std::ios::binary);
    if (!stream) return failure(file, "cannot be created", std::strerror(errno));
    stream << text;
    stream.close();
    if (!stream)
    {
        const std::string reason = std::strerror(errno);
        target.remove();
        return failure(file, "cannot be written", reason);
    }
    if (!target.isTemporary()) return viewlod::success();
    std::error_code failed;
    std::filesystem::rename(target.written, target.final, failed);
    if (!failed) return viewlod::success();
    target.remove();
    return failure(file, "cannot be put in place", failed.message());
}

viewlod::Outcome checkWritable(const std::filesystem::path& file)
{
    if (file.empty()) return viewlod::success();
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return viewlod::Error{file.string(), "is a folder", "name a file in it"};
    const Target target = targetOf(file);
    if (!target.isTemporary()) return viewlod::success(); // opening a pipe would wait for its reader
    const bool opened = std::ofstream(target.written, std::ios::binary).is_open();
    const std::string reason = std::strerror(errno);
    target.remove();
    return opened ? viewlod::success() : viewlod::Outcome(failure(file, "cannot be created", reason));
}

} // namespace terminal
