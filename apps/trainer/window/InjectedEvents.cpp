// SPDX-License-Identifier: Apache-2.0
#include "window/InjectedEvents.h"

#include "input/Keys.h"

namespace trainer
{

void InjectedEvents::send(int key, bool isDown)
{
    osgGA::EventQueue& queue = *_window->getEventQueue();
    if (isDown)
        queue.keyPress(key, queue.getTime(), key);
    else
        queue.keyRelease(key, queue.getTime(), key);
}

void InjectedEvents::playScript(double wallS)
{
    for (; _played < _script.size() && _script[_played].atS <= wallS; ++_played)
    {
        const WindowEvent& event = _script[_played];
        switch (event.kind)
        {
        case WindowEvent::Kind::press:
        case WindowEvent::Kind::release:
            send(event.key, event.kind == WindowEvent::Kind::press);
            break;
        case WindowEvent::Kind::resize:
            _window->setWindowRectangle(_window->getTraits()->x, _window->getTraits()->y, event.widthPx,
                                        event.heightPx);
            break;
        case WindowEvent::Kind::close:
            _window->getEventQueue()->closeWindow();
            break;
        }
    }
}

void InjectedEvents::moveHand(const simulation::ControlSwitch& manual,
                              const simulation::DynamicVehicle& vehicle, double nextS)
{
    if (!manual.isByHand()) return;
    for (const KeyStroke& stroke :
         _hand.decide(manual.manual(), manual.wishes(), vehicle.inputNames(), nextS))
        send(stroke.key, stroke.isDown);
    if (!manual.wishes().empty() && manual.automatic()->isDone()) send(*keyOf("Escape"), true);
}

} // namespace trainer
