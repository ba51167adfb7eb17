// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgOffscreen/PngFile>
#include <osgOffscreen/PngWriter>

namespace osgOffscreen
{

using foundation::Outcome;

PngWriter::PngWriter(std::size_t mostWaiting) : _mostWaiting(mostWaiting), _thread([this] { run(); }) {}

PngWriter::~PngWriter()
{
    {
        const std::lock_guard lock(_mutex);
        _isEnding = true;
    }
    _changed.notify_all();
    _thread.join();
}

Outcome PngWriter::outcome() const
{
    if (_error) return *_error;
    return foundation::success();
}

Outcome PngWriter::write(osg::ref_ptr<osg::Image> picture, std::filesystem::path path)
{
    std::unique_lock lock(_mutex);
    if (!picture && !_error)
        _error =
            foundation::Error{path.string(), "no picture came back from the graphics context", "draw again"};
    _changed.wait(lock, [this] { return _error || _waiting.size() < _mostWaiting; });
    if (!_error) _waiting.push_back({picture, std::move(path)});
    _changed.notify_all();
    return outcome();
}

Outcome PngWriter::finish()
{
    std::unique_lock lock(_mutex);
    _changed.wait(lock, [this] { return !_isWriting && (_error || _waiting.empty()); });
    return outcome();
}

std::size_t PngWriter::written() const
{
    const std::lock_guard lock(_mutex);
    return _written;
}

void PngWriter::run()
{
    std::unique_lock lock(_mutex);
    for (;;)
    {
        _changed.wait(lock, [this] { return _isEnding || (!_error && !_waiting.empty()); });
        if (_error || _waiting.empty()) return; // ending, and nothing left that can be written
        const Job job = std::move(_waiting.front());
        _waiting.pop_front();
        _isWriting = true;
        lock.unlock();
        const Outcome result = writePng(*job.picture, job.path);
        lock.lock();
        _isWriting = false;
        if (result)
            ++_written;
        else
            _error = result.error();
        _changed.notify_all();
    }
}

} // namespace osgOffscreen
