// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include <AL/al.h>
#include <AL/alc.h>

#include "simulation/sound/Synthesiser.h"
#include "sound/Loudspeaker.h"

namespace trainer
{

/// Keeps three buffers of 30 ms in the queue of a source.
struct Loudspeaker::Player
{
    static constexpr int kFrames = simulation::Synthesiser::kRate * 30 / 1000;

    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    ALuint source = 0;
    std::array<ALuint, 3> buffers{};
    std::mutex mutex; ///< for what follows
    simulation::SoundState state;
    bool isPaused = true;
    std::atomic<bool> isEnded{false};
    std::thread thread;

    bool open()
    {
        device = alcOpenDevice(nullptr);
        context = device ? alcCreateContext(device, nullptr) : nullptr;
        if (!context || !alcMakeContextCurrent(context)) return false;
        alGenSources(1, &source);
        alGenBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
        return alGetError() == AL_NO_ERROR;
    }

    ~Player()
    {
        isEnded = true;
        if (thread.joinable()) thread.join();
        alcMakeContextCurrent(nullptr);
        if (context) alcDestroyContext(context);
        if (device) alcCloseDevice(device);
    }

    void fill(simulation::Synthesiser& synthesiser, ALuint buffer)
    {
        simulation::SoundState now;
        bool isSilent = false;
        {
            const std::scoped_lock lock(mutex);
            now = state;
            isSilent = isPaused;
            state.bumpMps = 0.0; // once
        }
        std::vector<float> samples(2 * kFrames, 0.0F);
        if (!isSilent) synthesiser.render(now, samples);
        std::vector<std::int16_t> whole(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i)
            whole[i] = static_cast<std::int16_t>(std::lround(32767.0F * samples[i]));
        alBufferData(buffer, AL_FORMAT_STEREO16, whole.data(), static_cast<ALsizei>(2 * whole.size()),
                     simulation::Synthesiser::kRate);
        alSourceQueueBuffers(source, 1, &buffer);
    }

    void play()
    {
        simulation::Synthesiser synthesiser;
        for (const ALuint buffer : buffers)
            fill(synthesiser, buffer);
        alSourcePlay(source);
        while (!isEnded)
        {
            ALint done = 0, playing = AL_STOPPED;
            alGetSourcei(source, AL_BUFFERS_PROCESSED, &done);
            for (; done > 0; --done)
            {
                ALuint buffer = 0;
                alSourceUnqueueBuffers(source, 1, &buffer);
                fill(synthesiser, buffer);
            }
            alGetSourcei(source, AL_SOURCE_STATE, &playing);
            if (playing != AL_PLAYING) alSourcePlay(source); // it ran dry
            std::this_thread::sleep_for(std::chrono::milliseconds(8));
        }
        alSourceStop(source);
    }
};

Loudspeaker::Loudspeaker() : _player(std::make_shared<Player>())
{
    if (!_player->open())
    {
        _player.reset();
        _fault = "there is no device for sound";
        return;
    }
    _player->thread = std::thread([player = _player.get()] { player->play(); });
}

Loudspeaker::~Loudspeaker() = default;

void Loudspeaker::set(const simulation::SoundState& state)
{
    if (!_player) return;
    const std::scoped_lock lock(_player->mutex);
    const double bumpMps = _player->state.bumpMps;
    _player->state = state;
    _player->state.bumpMps = std::max(bumpMps, state.bumpMps);
    _player->isPaused = false;
}

void Loudspeaker::pause()
{
    if (!_player) return;
    const std::scoped_lock lock(_player->mutex);
    _player->isPaused = true;
}

} // namespace trainer
