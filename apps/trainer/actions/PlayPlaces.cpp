// SPDX-License-Identifier: Apache-2.0
#include "PlayPlaces.h"

#include <iostream>

#include "input/DeviceFile.h"
#include "input/KeyScript.h"
#include "scene/SceneScenery.h"
#include "scene/SceneTerrain.h"
#include "view/ViewFile.h"
#include "window/OpenWindow.h"

namespace trainer
{

namespace
{

foundation::Outcome checkSmallFiles(const PlayRequest& request)
{
    if (const auto& view = request.frames.viewFile; !view.empty())
    {
        const auto read = readView(view);
        if (!read) return read.error();
        for (const std::string& note : read->notes)
            std::cout << "note: " << note << '\n';
    }
    if (const auto& keys = request.window.keysFile; !keys.empty())
        if (const auto read = readKeyScript(keys); !read) return read.error();
    if (const auto& devices = request.window.devicesFile; !devices.empty())
        if (const auto read = readDevices(devices); !read) return read.error();
    return checkScenery(request.scenery);
}

} // namespace

terminal::Places placesOf(const PlayRequest& request)
{
    const OutputRequest& output = request.output;
    terminal::Places places;
    places.written = {output.statsFile, output.reportFile, request.sound.file, output.partsFile,
                      output.motionFile};
    places.folders = {{output.captureFolder, "frame_00000.png"}};
    if (request.seat)
    {
        places.written.push_back(request.seat->recordInputs);
        places.read.push_back(request.seat->inputs);
    }
    return places;
}

terminal::Places placesOf(const RideRequest& request)
{
    return {{request.recordInputs}, {}, {request.inputs}};
}

foundation::Outcome checkBeforePlay(const PlayRequest& request)
{
    if (const auto usable = terminal::checkPlaces(placesOf(request)); !usable) return usable;
    if (const auto sound = checkSmallFiles(request); !sound) return sound;
    if (request.window.isWanted)
        if (const auto display = checkDisplay(request.window); !display) return display;
    return request.terrain.file.empty() ? foundation::success()
                                        : checkScene(request.terrain.file, request.terrain);
}

foundation::Outcome checkBeforeRide(const RideRequest& request)
{
    if (const auto usable = terminal::checkPlaces(placesOf(request)); !usable) return usable;
    return request.hasWindow() ? checkDisplay(request.play.window) : foundation::success();
}

} // namespace trainer
