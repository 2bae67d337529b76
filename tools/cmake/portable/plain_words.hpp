/* Included before everything that is compiled for Windows: its headers, which spdlog includes, have macros for plain words. */
#pragma once

#define NOMINMAX
#define NOGDI
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#undef near
#undef far
#undef NEAR
#undef FAR
#define NEAR
#define FAR
