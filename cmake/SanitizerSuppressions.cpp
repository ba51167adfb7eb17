// SPDX-License-Identifier: Apache-2.0
// What sanitizers say of libraries that are not built with them. OSMesa keeps a buffer per context for good
// (osmesa.c, osmesa_destroy_buffer is never reached); the locks inside Mesa and OSG are not seen; OSG
// (RenderStageCache against ObserverSet, when a nested camera dies) and GDAL (opening against creating) take
// locks of their own in either order. OSG counts references to its observers unseen, so that the mutex of the
// last one seems to go while another thread holds it, and ends the pager's threads without joining them.
// Races of ours below a traversal of OSG's stay: only where OSG itself reads or writes are they passed over.
// Inline, for the object may be linked twice.
#if defined(__has_feature) // clang
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__
#endif
#endif

#if defined(__SANITIZE_ADDRESS__)
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions()
{
    return "leak:libOSMesa.so\nleak:libEGL\nleak:libGLdispatch\nleak:swrast_dri.so\nleak:libX11.so\n"
           "leak:libdbus-1.so\n"
           "leak:osgdb_osg.so\n" // its options, after a file that it cannot read
           "leak:libexpat.so\n"; // a parser of GDAL's that is begun for a file of another format
}

/// No library is unloaded: what one keeps would have no name that could be passed over.
extern "C" [[gnu::used]] inline int dlclose(void*)
{
    return 0;
}

/// What a program says on stderr is its own words, and tests read them.
extern "C" [[gnu::used]] inline const char* __lsan_default_options()
{
    return "print_suppressions=0";
}
#elif defined(__SANITIZE_THREAD__)
extern "C" [[gnu::used]] inline const char* __tsan_default_suppressions()
{
    return "race:libOSMesa.so\nrace:swrast_dri.so\nrace:libEGL\nmutex:libOSMesa.so\nmutex:swrast_dri.so\n"
           "deadlock:libOSMesa.so\ndeadlock:swrast_dri.so\nrace_top:libosg\nrace_top:libOpenThreads.so\n"
           "race:OpenThreads::Mutex::~Mutex\nthread:OpenThreads::Thread::start\n"
           "deadlock:libosg\ndeadlock:libgdal.so\n";
}

extern "C" [[gnu::used]] inline const char* __tsan_default_options()
{
    return "print_suppressions=0";
}
#endif
