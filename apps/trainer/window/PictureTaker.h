// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include <osg/Camera>

#include "window/WindowBuffer.h"

namespace trainer
{

/// Writes the picture of a window to a file when it is asked to: FOLDER/picture-1.png and on. As the final
/// callback of the camera that draws last.
/// Threads: ask() from any; the callback from the one that draws.
class PictureTaker : public osg::Camera::DrawCallback
{
public:
    explicit PictureTaker(std::filesystem::path folder) : _folder(std::move(folder)) {}

    /// The next picture that is drawn is written.
    void ask() { _isAsked = true; }

    /// Where the cameras draw; null: into the window.
    void readFrom(const osg::ref_ptr<WindowBuffer>& buffer) { _buffer = buffer; }

    /// What became of the last one, once: its file, or why there is none.
    std::optional<std::string> takeNote();

    void operator()(osg::RenderInfo& renderInfo) const override;

private:
    std::filesystem::path _folder;
    osg::ref_ptr<WindowBuffer> _buffer;
    mutable std::mutex _mutex; ///< for what follows
    mutable bool _isAsked = false;
    mutable int _count = 0;
    mutable std::optional<std::string> _note;
};

} // namespace trainer
