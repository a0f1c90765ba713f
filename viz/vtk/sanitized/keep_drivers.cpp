/// \file
/// For builds with AddressSanitizer, part of every program that draws.
///
/// Graphics drivers are loaded and unloaded by name. What one has kept to its end looks like a leak once the
/// driver is unloaded, and nobody knows any more whose it was: so here none is.

extern "C" int dlclose(void* /*handle*/);
extern "C" int dlclose(void* /*handle*/) { return 0; }
