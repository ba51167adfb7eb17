// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include <osg/observer_ptr>

#include <osgTraversal/EyeSharing>

#include "CullView.h"

namespace osgPMObjects
{

/// The view groups of one drawable thing. Cameras whose eyes coincide share a `Group`, and each camera has a
/// `PerCamera` in it. A camera that moves takes its group along. A camera that sees the thing at several
/// positions in a frame (below several transforms) has a group for each of them. A group is dropped when no
/// camera has asked for it for some frames (osgTraversal::isUnused), or its cameras are gone.
/// Threads: one at a time.
template<class Group, class PerCamera>
class EyeGroups
{
public:
    struct Member : PerCamera
    {
        osg::Camera* identity = nullptr; ///< only compared
        osg::observer_ptr<osg::Camera> camera;
        unsigned int frame = 0; ///< in which it asked last
    };

    struct Entry : Group
    {
        using Group::Group;

        glm::dvec3 eye{0.0};
        unsigned int frame = 0;
        std::vector<Member> members;

        Member* memberOf(const osg::Camera* camera)
        {
            const auto found = std::find_if(members.begin(), members.end(),
                                            [=](const Member& m) { return m.identity == camera; });
            return found == members.end() ? nullptr : &*found;
        }
    };

    /// Returns the group of a nested camera's main camera, if that sees the thing at one position only;
    /// otherwise it is ambiguous.
    /// `isMade(group)`: whether the group has anything to share.
    template<class IsMade>
    Entry* borrowed(const CullView& view, const IsMade& isMade)
    {
        if (!view.mainCamera) return nullptr;
        Entry* found = nullptr;
        for (Entry& entry : _entries)
        {
            if (!entry.memberOf(view.mainCamera) || !isMade(entry)) continue;
            if (found) return nullptr;
            found = &entry;
        }
        return found;
    }

    /// Returns the group of an eye, made from `of` if there is none, and makes the camera its member.
    /// `reachM`: distance from the 0 of the thing to its farthest point.
    template<class... Of>
    Entry& find(const CullView& view, double reachM, const Of&... of)
    {
        Entry* const known = entryFor(view, osgTraversal::sameEyeToleranceM(view.view.eyeWorld, reachM));
        Entry& entry = known ? *known : _entries.emplace_back(of...);
        entry.eye = view.view.eyeWorld;
        entry.frame = view.frame;
        memberOf(entry, view);
        return entry;
    }

    /// Returns the entry of a camera in a group, a new one if there is none.
    static Member& memberOf(Entry& entry, const CullView& view)
    {
        Member* member = entry.memberOf(view.camera);
        if (!member)
        {
            member = &entry.members.emplace_back();
            member->identity = view.camera;
            member->camera = view.camera;
        }
        member->frame = view.frame;
        return *member;
    }

    void dropUnused(unsigned int frame)
    {
        for (Entry& entry : _entries)
            std::erase_if(
                entry.members, [&](const Member& m)
                { return osgTraversal::isUnused(m.frame, frame) || (m.identity && !m.camera.valid()); });
        std::erase_if(_entries, [&](const Entry& entry)
                      { return osgTraversal::isUnused(entry.frame, frame) || entry.members.empty(); });
    }

    std::vector<Entry>& entries() { return _entries; }
    const std::vector<Entry>& entries() const { return _entries; }

private:
    Entry* entryFor(const CullView& view, double sameEyeM)
    {
        const glm::dvec3& eye = view.view.eyeWorld;
        Entry* own = nullptr;
        for (Entry& entry : _entries)
        {
            if (entry.frame == view.frame)
            {
                if (glm::distance(entry.eye, eye) <= sameEyeM) return &entry;
            }
            else if (entry.memberOf(view.camera) &&
                     (!own || glm::distance(entry.eye, eye) < glm::distance(own->eye, eye)))
                own = &entry;
        }
        return own;
    }

    std::vector<Entry> _entries;
};

} // namespace osgPMObjects
