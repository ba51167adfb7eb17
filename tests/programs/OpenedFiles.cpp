// SPDX-License-Identifier: Apache-2.0
#include "OpenedFiles.h"

#include <cstring>

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

OpenedFiles::OpenedFiles(const std::filesystem::path& folder)
    : _events(inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
{
    EXPECT_GE(inotify_add_watch(_events, folder.c_str(), IN_OPEN), 0) << folder;
}

OpenedFiles::~OpenedFiles()
{
    close(_events);
}

std::map<std::string, int> OpenedFiles::take()
{
    std::map<std::string, int> opened;
    alignas(inotify_event) char bytes[65536];
    for (ssize_t count = 0; (count = read(_events, bytes, sizeof bytes)) > 0;)
        for (ssize_t at = 0; at < count;)
        {
            inotify_event event{};
            std::memcpy(&event, bytes + at, sizeof event);
            EXPECT_EQ(event.mask & IN_Q_OVERFLOW, 0U) << "events were lost";
            if (event.len > 0) ++opened[bytes + at + sizeof event];
            at += static_cast<ssize_t>(sizeof event + event.len);
        }
    return opened;
}
