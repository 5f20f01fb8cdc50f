// What every stand-in exports: the vendor's names, and beside them these.
#pragma once

#define STANDIN_EXPORT extern "C" __attribute__((visibility("default")))

// 0, or -1 where there is no such key. "1.unplug" is the second device's, "unplug" that of all.
STANDIN_EXPORT int standin_set(const char* key, double value);
// NaN where there is no such key; "unplug" is the first device's.
STANDIN_EXPORT double standin_get(const char* key);
// Writes keys, counters and calls; 0, or -1 where the file cannot be written.
STANDIN_EXPORT int standin_log(const char* path);
// Everything as when the library was loaded: closed, no calls, the keys of the start and of the
// environment.
STANDIN_EXPORT void standin_reset();
