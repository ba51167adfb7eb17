// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <foundation/Result.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace foundation
{

/// A file as text that is in memory only where it is read.
class MappedFile
{
public:
    /// Errors: no such file, not a file, no permission.
    static Result<MappedFile> open(const std::filesystem::path& file)
    {
        const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
        struct stat status
        {
        };
        MappedFile mapped;
        const bool isThere = descriptor >= 0 && ::fstat(descriptor, &status) == 0;
        if (isThere && S_ISREG(status.st_mode) && status.st_size > 0)
        {
            void* bytes = ::mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ, MAP_PRIVATE,
                                 descriptor, 0);
            if (bytes != MAP_FAILED)
                mapped._text = {static_cast<const char*>(bytes), static_cast<std::size_t>(status.st_size)};
        }
        const int reason = errno;
        if (descriptor >= 0) ::close(descriptor);
        if (!isThere || !S_ISREG(status.st_mode) || (status.st_size > 0 && mapped._text.empty()))
            return Error{file.string(),
                         "cannot be read: " + (isThere ? std::string("it is no plain file")
                                                       : std::generic_category().message(reason)),
                         "check the path and its permissions"};
        return mapped;
    }

    ~MappedFile()
    {
        if (!_text.empty()) ::munmap(const_cast<char*>(_text.data()), _text.size());
    }
    MappedFile(MappedFile&& other) noexcept : _text(std::exchange(other._text, {})) {}
    MappedFile& operator=(MappedFile&& other) noexcept
    {
        std::swap(_text, other._text);
        return *this;
    }

    std::string_view text() const { return _text; }

    /// Brings all of it into memory at once, which takes less time than doing so where it is read.
    void fetchAll() const
    {
#ifdef MADV_POPULATE_READ
        if (!_text.empty()) ::madvise(const_cast<char*>(_text.data()), _text.size(), MADV_POPULATE_READ);
#endif
    }

    /// Frees the memory of what has been read; it is read from the file again when it is asked for.
    void forget() const
    {
        if (!_text.empty()) ::madvise(const_cast<char*>(_text.data()), _text.size(), MADV_DONTNEED);
    }

private:
    MappedFile() = default;

    std::string_view _text;
};

} // namespace foundation
