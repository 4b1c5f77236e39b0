// One source, several machine codes: a function marked ANAMORPH_TARGET_CLONES is compiled for plain x86-64, for
// x86-64-v3 (AVX2) and for x86-64-v4 (AVX-512), and the loader picks what the processor has. Elsewhere (other
// processors and compilers, sanitizers, which do not survive the loader's early call) the mark means nothing.
#pragma once

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ANAMORPH_TARGET_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define ANAMORPH_TARGET_CLONES
#endif
