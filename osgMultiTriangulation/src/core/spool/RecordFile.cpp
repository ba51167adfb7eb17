// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <osgMultiTriangulation/core/spool/RecordFile.h>

namespace osgMultiTriangulation::core
{

PlacedBytes::~PlacedBytes()
{
    if (_descriptor >= 0) ::close(_descriptor);
}

PlacedBytes::PlacedBytes(PlacedBytes&& other) noexcept
    : _file(std::move(other._file)),
      _descriptor(std::exchange(other._descriptor, -1)),
      _failure(std::move(other._failure))
{
}

PlacedBytes& PlacedBytes::operator=(PlacedBytes&& other) noexcept
{
    std::swap(_file, other._file);
    std::swap(_descriptor, other._descriptor);
    std::swap(_failure, other._failure);
    return *this;
}

foundation::Result<PlacedBytes> PlacedBytes::open(const std::filesystem::path& file, bool create)
{
    PlacedBytes bytes;
    bytes._file = file;
    bytes._failure = std::make_unique<std::uint32_t>(0);
    bytes._descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | (create ? O_CREAT | O_TRUNC : 0), 0666);
    if (bytes._descriptor < 0) bytes.fail(errno);
    if (const auto outcome = bytes.outcome(); !outcome) return outcome.error();
    return bytes;
}

void PlacedBytes::read(std::span<std::byte> bytes, std::uint64_t place) const
{
    while (!bytes.empty())
    {
        const ssize_t taken = ::pread(_descriptor, bytes.data(), bytes.size(), static_cast<off_t>(place));
        if (taken < 0 && errno == EINTR) continue;
        if (taken <= 0)
        {
            fail(taken < 0 ? errno : EIO);
            std::ranges::fill(bytes, std::byte{0});
            return;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(taken));
        place += static_cast<std::uint64_t>(taken);
    }
}

void PlacedBytes::write(std::span<const std::byte> bytes, std::uint64_t place) const
{
    while (!bytes.empty())
    {
        const ssize_t given = ::pwrite(_descriptor, bytes.data(), bytes.size(), static_cast<off_t>(place));
        if (given < 0 && errno == EINTR) continue;
        if (given <= 0) return fail(given < 0 ? errno : EIO);
        bytes = bytes.subspan(static_cast<std::size_t>(given));
        place += static_cast<std::uint64_t>(given);
    }
}

std::uint64_t PlacedBytes::size() const
{
    struct stat status
    {
    };
    if (::fstat(_descriptor, &status) != 0) fail(errno);
    return static_cast<std::uint64_t>(status.st_size);
}

void PlacedBytes::fail(int reason) const
{
    std::atomic_ref(*_failure).store(static_cast<std::uint32_t>(reason));
}

foundation::Outcome PlacedBytes::outcome() const
{
    const std::uint32_t reason = _failure ? std::atomic_ref(*_failure).load() : 0;
    if (reason == 0) return foundation::success();
    return foundation::Error{_file.string(),
                             "cannot be read or written: " +
                                 std::generic_category().message(static_cast<int>(reason)),
                             "check that its folder is writable and has room"};
}

} // namespace osgMultiTriangulation::core
