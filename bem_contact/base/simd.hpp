#pragma once

/// Before a small loop that is worth compiling for the processor's wider registers as well; which is used is
/// decided when the program is loaded, which programs of the format ELF can do. Not under sanitizers: what
/// decides is instrumented too, and would call their functions before they are there.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) &&                   \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BEM_CONTACT_WIDE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define BEM_CONTACT_WIDE
#endif
