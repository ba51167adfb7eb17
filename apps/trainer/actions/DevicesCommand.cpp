// SPDX-License-Identifier: Apache-2.0
#include "DevicesCommand.h"

#include <chrono>
#include <cstdio>
#include <thread>

#include "input/DeviceFile.h"
#include "input/Devices.h"
#include "window/EndSignals.h"

namespace trainer
{

namespace
{

constexpr auto kBetweenLooks = std::chrono::milliseconds(200);

void tellDevice(const DeviceState& device, const std::vector<DeviceMap>& maps)
{
    std::printf("%s: %zu axes, %zu buttons", device.name.c_str(), device.axes.size(),
                device.isPressed.size());
    if (const DeviceMap* const map = mapFor(maps, device.name))
        for (const DeviceAxis& axis : map->axes)
            std::printf(", axis %d %s", axis.axis, axis.input.c_str());
    std::printf("\n");
}

void showDevice(const DeviceState& device)
{
    std::printf("%s:", device.name.c_str());
    for (const double axis : device.axes)
        std::printf(" %6.3f", axis);
    for (std::size_t i = 0; i < device.isPressed.size(); ++i)
        if (device.isPressed[i]) std::printf(" button %zu", i);
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

foundation::Outcome listDevices(const DevicesRequest& request)
{
    std::vector<DeviceMap> maps;
    if (!request.devicesFile.empty())
    {
        auto read = readDevices(request.devicesFile);
        if (!read) return read.error();
        maps = std::move(*read);
    }
    Devices devices;
    if (!devices.fault().empty())
        return foundation::Error{"devices", devices.fault(), "build with libsdl2-dev, or use the keys"};
    devices.update();
    if (devices.states().empty()) std::printf("no device is there\n");
    for (const DeviceState& device : devices.states())
        tellDevice(device, maps);
    const EndSignals signals;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(request.liveS);
    while (!signals.haveCome() && std::chrono::steady_clock::now() < end)
    {
        for (const std::string& note : devices.update())
            std::printf("%s\n", note.c_str());
        for (const DeviceState& device : devices.states())
            showDevice(device);
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return foundation::success();
}

} // namespace trainer
